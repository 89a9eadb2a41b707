#include "services/library/sqlite_action_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <limits>

#include "common/actions/build_version.h"
#include "services/library/content_json.h"
#include "services/library/record_json.h"
#include "services/library/sqlite_schema.h"

namespace cell::library {
namespace {

constexpr char kLocked[] =
    "cannot be opened for writing; do file and folder exist, and may this user "
    "write to both?";

std::string WhatToDo(const SQLite::Exception& e) {
  switch (e.getErrorCode()) {
    case SQLITE_NOTADB:
      return "is not an SQLite database; name another file, or move it away";
    case SQLITE_CORRUPT:
      return kDamagedStore;
    case SQLITE_FULL:
      return "the disk is full; free some space";
    case SQLITE_IOERR:
      return fmt::format("cannot be read or written ({}); check the disk",
                         e.what());
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return kOwnedByAnother;
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return kLocked;
    default:
      return e.what();
  }
}

[[noreturn]] void Fail(const std::filesystem::path& file,
                       const std::string& what) {
  throw StoreError(file.string() + ": " + what);
}

// What is to be opened in place of a library that cannot be written.
std::optional<LibraryCopy> CopyIfLocked(const std::filesystem::path& file,
                                        SqliteActionStore::Mode mode) {
  std::error_code error;  // e.g. a folder that this user may not enter
  const bool is_there = std::filesystem::exists(file, error);
  if (error) Fail(file, kLocked);
  const bool is_locked = is_there && !LibraryCopy::IsWritable(file);
  if (mode == SqliteActionStore::Mode::kCreate) {
    if (is_locked) Fail(file, kLocked);
    return std::nullopt;
  }
  if (!is_there) Fail(file, "there is no such library");
  if (std::filesystem::is_empty(file, error)) {
    Fail(file, "is empty; name a library");
  }
  if (!is_locked) return std::nullopt;
  try {
    return std::make_optional<LibraryCopy>(file);
  } catch (const std::runtime_error& e) {
    throw StoreError(e.what());
  }
}

std::unique_ptr<SQLite::Database> Open(const std::filesystem::path& opened,
                                       const std::filesystem::path& file) {
  try {
    return std::make_unique<SQLite::Database>(
        opened.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  } catch (const SQLite::Exception& e) {
    Fail(file, WhatToDo(e));
  }
}

std::string TextFrom(SQLite::Database& database, const char* query) {
  SQLite::Statement statement(database, query);
  return statement.executeStep() ? statement.getColumn(0).getString() : "";
}

ActionRecord RecordFrom(const SQLite::Statement& row,
                        const std::filesystem::path& file) {
  const int64_t id = row.getColumn(0).getInt64();
  const std::string where = fmt::format("{}:action {}", file.string(), id);
  try {
    const auto content =
        nlohmann::json::parse(row.getColumn(1).getString(), nullptr, false);
    ActionRecord record = RecordFromJson(content, where);
    if (record.id != id) throw std::invalid_argument(where + ".id: is another");
    return record;
  } catch (const std::invalid_argument& e) {
    throw StoreError(std::string(e.what()) + "; the file " + kDamagedStore);
  }
}

StoreChange ChangeFrom(const SQLite::Statement& row) {
  return {row.getColumn(0).getInt64(), row.getColumn(1).getString(),
          row.getColumn(2).getString()};
}

}  // namespace

template <class Function>
auto SqliteActionStore::Guarded(Function function) const {
  try {
    return function();
  } catch (const SQLite::Exception& e) {
    Fail(file_, WhatToDo(e));
  }
}

SqliteActionStore::SqliteActionStore(const std::filesystem::path& file,
                                     Mode mode)
    : file_(file),
      copy_(CopyIfLocked(file, mode)),
      database_(Open(copy_ ? copy_->path() : file, file)),
      experiences_(*database_, file) {
  Guarded([&] {
    // First of all: then no second process can get in between.
    database_->exec("PRAGMA locking_mode = EXCLUSIVE");
    if (TextFrom(*database_, "PRAGMA integrity_check") != "ok") {
      Fail(file_, kDamagedStore);
    }
    try {
      schema_version();  // what is not known is left as it is
      TextFrom(*database_, "PRAGMA journal_mode = WAL");
      database_->exec("PRAGMA synchronous = FULL");
      Migrate(*database_, LibrarySchema());
    } catch (const std::invalid_argument& e) {
      Fail(file_, e.what());
    }
  });
}

SqliteActionStore::~SqliteActionStore() = default;

StoredIds SqliteActionStore::Apply(const StoreEdit& edit, int32_t tick) {
  RequireWritable();
  return Guarded([&] {
    SQLite::Transaction transaction(*database_);
    StoredIds ids{InsertRecords(edit.records, tick), {}};
    for (const int64_t id : edit.removed_experiences) {
      experiences_.Remove(id, tick);
    }
    for (const ExperienceRecord& experience : edit.experiences) {
      ids.experiences.push_back(experiences_.Add(experience, tick));
    }
    transaction.commit();
    return ids;
  });
}

void SqliteActionStore::RequireWritable() const {
  if (copy_) Fail(file_, kLocked);
}

/// Within a transaction.
std::vector<int64_t> SqliteActionStore::InsertRecords(
    std::span<const ActionRecord> records, int32_t tick) {
  SQLite::Statement insert(
      *database_,
      "INSERT INTO action (id, name, version, record, tick, change) VALUES "
      "(?, ?, ?, ?, ?, (SELECT ifnull(max(number), 0) FROM change))");
  int64_t id = 0;
  {
    SQLite::Statement last(*database_, "SELECT max(id) FROM action");
    if (last.executeStep()) id = last.getColumn(0).getInt64();
  }
  std::vector<int64_t> ids;
  for (ActionRecord record : records) {
    const auto known = FindNamed(record.name);
    if (known && known->version >= record.version) {
      throw std::invalid_argument("an action '" + record.name +
                                  "' already exists");
    }
    record.id = ++id;
    insert.bind(1, id);
    insert.bind(2, record.name);
    insert.bind(3, record.version);
    insert.bind(4, JsonOf(record));
    insert.bind(5, tick);
    insert.exec();
    insert.reset();
    ids.push_back(id);
  }
  return ids;
}

std::optional<ActionRecord> SqliteActionStore::Find(int64_t id) const {
  return Guarded([&]() -> std::optional<ActionRecord> {
    SQLite::Statement rows(*database_,
                           "SELECT id, record FROM action WHERE id = ?");
    rows.bind(1, id);
    if (!rows.executeStep()) return std::nullopt;
    return RecordFrom(rows, file_);
  });
}

std::optional<ActionRecord> SqliteActionStore::FindNamed(
    const std::string& name) const {
  return Guarded([&]() -> std::optional<ActionRecord> {
    SQLite::Statement rows(*database_,
                           "SELECT id, record FROM action WHERE name = ? "
                           "ORDER BY version DESC LIMIT 1");
    rows.bind(1, name);
    if (!rows.executeStep()) return std::nullopt;
    return RecordFrom(rows, file_);
  });
}

/// Of each name, as stored before the tick.
std::vector<ActionRecord> SqliteActionStore::Latest(int32_t before_tick) const {
  return Guarded([&] {
    std::vector<ActionRecord> records;
    SQLite::Statement rows(*database_,
                           "SELECT id, record, max(version) FROM action WHERE "
                           "tick < ? GROUP BY name ORDER BY id");
    rows.bind(1, before_tick);
    while (rows.executeStep()) records.push_back(RecordFrom(rows, file_));
    return records;
  });
}

std::vector<ActionRecord> SqliteActionStore::All() const {
  return Latest(std::numeric_limits<int32_t>::max());
}

std::vector<ExperienceRecord> SqliteActionStore::ExperiencesFrom(
    int64_t first_id, int64_t max) const {
  return Guarded([&] { return experiences_.Read(first_id, max); });
}

int64_t SqliteActionStore::NumExperiences() const {
  return Guarded([&] { return experiences_.Count(); });
}

LibraryContent SqliteActionStore::Content() const {
  return Guarded([&] {
    return LibraryContent{All(), Experiences(), experiences_.last_id()};
  });
}

LibraryContent SqliteActionStore::BeforeRun() const {
  return Guarded([&] {
    return LibraryContent{Latest(kBeforeRun + 1), experiences_.BeforeRun(),
                          experiences_.last_id()};
  });
}

int64_t SqliteActionStore::Count() const {
  return Guarded([&] {
    SQLite::Statement row(*database_,
                          "SELECT count(DISTINCT name) FROM action");
    return row.executeStep() ? row.getColumn(0).getInt64() : 0;
  });
}

void SqliteActionStore::BeginRun() {
  RequireWritable();
  Guarded([&] {
    SQLite::Transaction transaction(*database_);
    SQLite::Statement update(*database_,
                             "UPDATE action SET tick = ? WHERE tick <> ?");
    update.bind(1, kBeforeRun);
    update.bind(2, kBeforeRun);
    update.exec();
    database_->exec(
        "DELETE FROM action AS old WHERE EXISTS (SELECT 1 FROM action WHERE "
        "name = old.name AND version > old.version)");
    experiences_.BeginRun();
    transaction.commit();
  });
}

void SqliteActionStore::RollBackTo(int32_t tick) {
  RequireWritable();
  Guarded([&] {
    SQLite::Transaction transaction(*database_);
    SQLite::Statement remove(*database_, "DELETE FROM action WHERE tick >= ?");
    remove.bind(1, tick);
    remove.exec();
    experiences_.RollBackTo(tick);
    transaction.commit();
  });
}

void SqliteActionStore::BeginChange(const std::string& what) {
  RequireWritable();
  const std::string before = TextOfContent({.actions = All()});
  Guarded([&] {
    SQLite::Transaction transaction(*database_);
    SQLite::Statement idle(*database_,
                           "DELETE FROM change WHERE before = ? AND number = "
                           "(SELECT max(number) FROM change) AND NOT EXISTS "
                           "(SELECT 1 FROM experience WHERE change = number OR "
                           "removed_change = number)");
    idle.bind(1, before);
    idle.exec();
    SQLite::Statement insert(
        *database_,
        "INSERT INTO change (number, what, build, before) VALUES "
        "((SELECT ifnull(max(number), 0) + 1 FROM change), ?, ?, ?)");
    insert.bind(1, what);
    insert.bind(2, BuildVersion());
    insert.bind(3, before);
    insert.exec();
    SQLite::Statement remove(*database_,
                             "DELETE FROM change WHERE number <= "
                             "(SELECT max(number) FROM change) - ?");
    remove.bind(1, kMaxChanges);
    remove.exec();
    experiences_.Trim(kMaxChanges);
    transaction.commit();
  });
}

std::vector<StoreChange> SqliteActionStore::Changes() const {
  return Guarded([&] {
    std::vector<StoreChange> changes;
    SQLite::Statement rows(
        *database_, "SELECT number, what, build FROM change ORDER BY number");
    while (rows.executeStep()) changes.push_back(ChangeFrom(rows));
    return changes;
  });
}

std::optional<StoreChange> SqliteActionStore::ChangeOf(int64_t id) const {
  return Guarded([&]() -> std::optional<StoreChange> {
    SQLite::Statement rows(*database_,
                           "SELECT number, what, build FROM change WHERE "
                           "number = (SELECT change FROM action WHERE id = ?)");
    rows.bind(1, id);
    if (!rows.executeStep()) return std::nullopt;
    return ChangeFrom(rows);
  });
}

std::optional<LibraryContent> SqliteActionStore::ContentBefore(
    int64_t number) const {
  return Guarded([&]() -> std::optional<LibraryContent> {
    SQLite::Statement rows(*database_,
                           "SELECT before FROM change WHERE number = ?");
    rows.bind(1, number);
    if (!rows.executeStep()) return std::nullopt;
    const std::string where =
        fmt::format("{}:change {}", file_.string(), number);
    try {
      return LibraryContent{
          ContentFromText(rows.getColumn(0).getString(), where).actions,
          experiences_.BeforeChange(number), experiences_.last_id()};
    } catch (const std::invalid_argument& e) {
      throw StoreError(std::string(e.what()) + "; the file " + kDamagedStore);
    }
  });
}

int SqliteActionStore::schema_version() const {
  return Guarded([&] {
    return SchemaVersion(*database_, static_cast<int>(LibrarySchema().size()));
  });
}

}  // namespace cell::library
