#include "services/library/sqlite_experiences.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "services/library/action_store.h"
#include "services/library/experience_json.h"

namespace cell::library {
namespace {

ExperienceRecord ExperienceFrom(const SQLite::Statement& row,
                                const std::filesystem::path& file) {
  const int64_t id = row.getColumn(0).getInt64();
  const std::string where = fmt::format("{}:experience {}", file.string(), id);
  try {
    const auto content =
        nlohmann::json::parse(row.getColumn(1).getString(), nullptr, false);
    ExperienceRecord experience = ExperienceFromJson(content, where);
    if (experience.id != id) {
      throw std::invalid_argument(where + ".id: is another");
    }
    return experience;
  } catch (const std::invalid_argument& e) {
    throw StoreError(std::string(e.what()) + "; the file " + kDamagedStore);
  }
}

int64_t NumberFrom(SQLite::Database& database, const char* query) {
  SQLite::Statement row(database, query);
  return row.executeStep() ? row.getColumn(0).getInt64() : 0;
}

void Execute(SQLite::Database& database, const char* text, int64_t number) {
  SQLite::Statement statement(database, text);
  statement.bind(1, number);
  statement.exec();
}

}  // namespace

int64_t SqliteExperiences::Add(const ExperienceRecord& experience,
                               int32_t tick) {
  ExperienceRecord stored = experience;
  stored.id = last_id() + 1;
  SQLite::Statement insert(
      database_,
      "INSERT INTO experience (id, experience, tick, change) VALUES (?, ?, ?, "
      "(SELECT ifnull(max(number), 0) FROM change))");
  insert.bind(1, stored.id);
  insert.bind(2, JsonOf(stored));
  insert.bind(3, tick);
  insert.exec();
  return stored.id;
}

void SqliteExperiences::Remove(int64_t id, int32_t tick) {
  SQLite::Statement update(
      database_,
      "UPDATE experience SET removed_tick = ?, removed_change = (SELECT "
      "ifnull(max(number), 0) FROM change) WHERE id = ? AND removed_tick IS "
      "NULL");
  update.bind(1, tick);
  update.bind(2, id);
  if (update.exec() == 0) {
    throw std::invalid_argument(fmt::format("there is no experience {}", id));
  }
}

std::vector<ExperienceRecord> SqliteExperiences::ReadAll(
    SQLite::Statement* rows) const {
  std::vector<ExperienceRecord> experiences;
  while (rows->executeStep()) {
    experiences.push_back(ExperienceFrom(*rows, file_));
  }
  return experiences;
}

std::vector<ExperienceRecord> SqliteExperiences::Read(int64_t first_id,
                                                      int64_t max) const {
  SQLite::Statement rows(database_,
                         "SELECT id, experience FROM experience WHERE id >= ? "
                         "AND removed_tick IS NULL ORDER BY id LIMIT ?");
  rows.bind(1, first_id);
  rows.bind(2, max);
  return ReadAll(&rows);
}

std::vector<ExperienceRecord> SqliteExperiences::BeforeRun() const {
  SQLite::Statement rows(
      database_,
      "SELECT id, experience FROM experience WHERE tick <= ?1 AND "
      "(removed_tick IS NULL OR removed_tick > ?1) ORDER BY id");
  rows.bind(1, kBeforeRun);
  return ReadAll(&rows);
}

std::vector<ExperienceRecord> SqliteExperiences::BeforeChange(
    int64_t number) const {
  SQLite::Statement rows(
      database_,
      "SELECT id, experience FROM experience WHERE change < ?1 AND "
      "(removed_change IS NULL OR removed_change >= ?1) ORDER BY id");
  rows.bind(1, number);
  return ReadAll(&rows);
}

int64_t SqliteExperiences::Count() const {
  return NumberFrom(
      database_, "SELECT count(*) FROM experience WHERE removed_tick IS NULL");
}

int64_t SqliteExperiences::last_id() const {
  return NumberFrom(database_, "SELECT ifnull(max(id), 0) FROM experience");
}

void SqliteExperiences::BeginRun() {
  Execute(database_, "UPDATE experience SET tick = ?1 WHERE tick <> ?1",
          kBeforeRun);
  Execute(database_,
          "UPDATE experience SET removed_tick = ?1 WHERE removed_tick <> ?1",
          kBeforeRun);
}

void SqliteExperiences::RollBackTo(int32_t tick) {
  Execute(database_, "DELETE FROM experience WHERE tick >= ?", tick);
  Execute(database_,
          "UPDATE experience SET removed_tick = NULL, removed_change = NULL "
          "WHERE removed_tick >= ?",
          tick);
}

void SqliteExperiences::Trim(int64_t num_changes) {
  Execute(database_,
          "DELETE FROM experience WHERE removed_change <= (SELECT max(number) "
          "FROM change) - ?",
          num_changes);
}

}  // namespace cell::library
