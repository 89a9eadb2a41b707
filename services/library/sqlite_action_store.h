#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "services/library/action_store.h"
#include "services/library/library_copy.h"
#include "services/library/sqlite_experiences.h"

namespace SQLite {
class Database;
}

namespace cell::library {

/// Keeps actions and experiences in an SQLite file, which this process owns
/// exclusively as long as the object exists. Storage adapter. A transaction is
/// on the disk when it returns (WAL, full sync): a death at any moment loses
/// none of them.
class SqliteActionStore final : public ActionStore {
 public:
  enum class Mode {
    kCreate,   ///< makes the file if it is not there
    kExisting  ///< it must be there; where this user cannot write, a copy of
               ///< it is read, and nothing can be stored
  };

  /// Checks the file and brings it to the newest schema. @throws StoreError
  /// that names the file and what to do: it is damaged, another program's, of a
  /// newer schema, owned by another process, not to be opened.
  SqliteActionStore(const std::filesystem::path& file, Mode mode);
  ~SqliteActionStore() override;

  StoredIds Apply(const StoreEdit& edit, int32_t tick) override;
  std::optional<ActionRecord> Find(int64_t id) const override;
  std::optional<ActionRecord> FindNamed(const std::string& name) const override;
  std::vector<ActionRecord> All() const override;
  int64_t Count() const override;
  std::vector<ExperienceRecord> ExperiencesFrom(int64_t first_id,
                                                int64_t max) const override;
  int64_t NumExperiences() const override;
  LibraryContent Content() const override;
  LibraryContent BeforeRun() const override;
  void BeginRun() override;
  void RollBackTo(int32_t tick) override;
  void BeginChange(const std::string& what) override;
  std::vector<StoreChange> Changes() const override;
  std::optional<StoreChange> ChangeOf(int64_t id) const override;
  std::optional<LibraryContent> ContentBefore(int64_t number) const override;
  int schema_version() const override;

 private:
  std::vector<ActionRecord> Latest(int32_t before_tick) const;
  std::vector<int64_t> InsertRecords(std::span<const ActionRecord> records,
                                     int32_t tick);
  template <class Function>
  auto Guarded(Function function) const;
  /// @throws StoreError if this user cannot write the file
  void RequireWritable() const;

  std::filesystem::path file_;
  std::optional<LibraryCopy> copy_;  // outlives the database
  std::unique_ptr<SQLite::Database> database_;
  SqliteExperiences experiences_;
};

}  // namespace cell::library
