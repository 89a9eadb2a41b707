#include "services/library/sqlite_schema.h"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>

#include "common/actions/build_version.h"

namespace cell::library {
namespace {

// "CELL": distinguishes a library's file from other programs'.
constexpr int kApplicationId = 0x43454c4c;

constexpr std::array kSteps = {
    // record: JSON (record_json.h). tick: in which it was stored in the run
    // that lasts, -1: before it.
    R"sql(
      CREATE TABLE action (
        id INTEGER PRIMARY KEY,
        name TEXT NOT NULL UNIQUE,
        record TEXT NOT NULL,
        tick INTEGER NOT NULL
      ) STRICT;
    )sql",
    // version: counts the records of a name.
    R"sql(
      ALTER TABLE action RENAME TO unversioned;
      CREATE TABLE action (
        id INTEGER PRIMARY KEY,
        name TEXT NOT NULL,
        version INTEGER NOT NULL,
        record TEXT NOT NULL,
        tick INTEGER NOT NULL,
        UNIQUE (name, version)
      ) STRICT;
      INSERT INTO action
        SELECT id, name, 1, json_set(record, '$.version', 1), tick
        FROM unversioned;
      DROP TABLE unversioned;
    )sql",
    // change: what was done to the library, and the content (record_json.h)
    // before it; of an action: by which it was stored, 0: not known.
    R"sql(
      CREATE TABLE change (
        number INTEGER PRIMARY KEY,
        what TEXT NOT NULL,
        build TEXT NOT NULL,
        before TEXT NOT NULL
      ) STRICT;
      ALTER TABLE action ADD COLUMN change INTEGER NOT NULL DEFAULT 0;
    )sql",
    // experience: JSON (experience_json.h). removed_tick, removed_change: in
    // and
    // by which it was removed; NULL: it is there.
    R"sql(
      CREATE TABLE experience (
        id INTEGER PRIMARY KEY,
        experience TEXT NOT NULL,
        tick INTEGER NOT NULL,
        change INTEGER NOT NULL,
        removed_tick INTEGER,
        removed_change INTEGER
      ) STRICT;
    )sql",
};

int Number(const SQLite::Database& database, const char* query) {
  SQLite::Statement statement(database, query);
  return statement.executeStep() ? statement.getColumn(0).getInt() : 0;
}

/// The build that changed a newer database last, as far as it says.
std::string LastBuild(const SQLite::Database& database) {
  if (database.tableExists("change")) {
    SQLite::Statement last(
        database, "SELECT build FROM change ORDER BY number DESC LIMIT 1");
    if (last.executeStep()) return "build " + last.getColumn(0).getString();
  }
  return "the build of the cell that wrote it";
}

}  // namespace

std::span<const char* const> LibrarySchema() {
  return kSteps;
}

int SchemaVersion(const SQLite::Database& database, int newest) {
  const int version = Number(database, "PRAGMA user_version");
  const int application = Number(database, "PRAGMA application_id");
  const int num_tables = Number(database, "SELECT count(*) FROM sqlite_schema");
  if (version == 0 && application == 0 && num_tables == 0) return 0;
  if (application != kApplicationId || version < 1) {
    throw std::invalid_argument(
        "is the database of another program; name another file");
  }
  if (version > newest) {
    throw std::invalid_argument(
        fmt::format("has schema {}, newer than {}, the newest known to this "
                    "build ({}); use "
                    "{}, or a newer one",
                    version, newest, BuildVersion(), LastBuild(database)));
  }
  return version;
}

void Migrate(SQLite::Database& database, std::span<const char* const> steps) {
  const int newest = static_cast<int>(steps.size());
  const int version = SchemaVersion(database, newest);
  if (version == newest) return;
  SQLite::Transaction transaction(database);
  for (int i = version; i < newest; ++i) {
    database.exec(steps[static_cast<size_t>(i)]);
  }
  database.exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
  database.exec(fmt::format("PRAGMA user_version = {}", newest));
  transaction.commit();
}

}  // namespace cell::library
