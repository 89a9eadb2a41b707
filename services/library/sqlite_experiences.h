#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "common/experiences/experience_record.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace cell::library {

/// The experiences in a library's database. One that was removed is kept as
/// long as the change that did it, to go back to. Storage adapter, part of
/// SqliteActionStore: a call is part of the transaction that is open, and
/// throws SQLite::Exception.
class SqliteExperiences {
 public:
  /// @param file  named by errors
  SqliteExperiences(SQLite::Database& database, std::filesystem::path file)
      : database_(database), file_(std::move(file)) {}

  /// Its id. Of the last change, as the removals.
  int64_t Add(const ExperienceRecord& experience, int32_t tick);
  /// @throws std::invalid_argument if it is not there.
  void Remove(int64_t id, int32_t tick);

  /// From the id on, at most so many, by id.
  /// @throws StoreError naming one that cannot be read, as the next two.
  std::vector<ExperienceRecord> Read(int64_t first_id, int64_t max) const;
  std::vector<ExperienceRecord> BeforeRun() const;
  std::vector<ExperienceRecord> BeforeChange(int64_t number) const;
  int64_t Count() const;
  /// The highest id that is taken.
  int64_t last_id() const;

  void BeginRun();
  void RollBackTo(int32_t tick);
  /// Forgets what was removed before the last so many changes.
  void Trim(int64_t num_changes);

 private:
  std::vector<ExperienceRecord> ReadAll(SQLite::Statement* rows) const;

  SQLite::Database& database_;
  std::filesystem::path file_;
};

}  // namespace cell::library
