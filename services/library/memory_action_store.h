#pragma once

#include "services/library/action_store.h"
#include "services/library/memory_experiences.h"

namespace cell::library {

/// Keeps actions and experiences in memory: for replay, evaluations and tests.
class MemoryActionStore final : public ActionStore {
 public:
  /// Holds these from before the run.
  explicit MemoryActionStore(std::span<const ActionRecord> records = {});
  /// The same, with the ids that they have.
  explicit MemoryActionStore(const LibraryContent& content);

  StoredIds Apply(const StoreEdit& edit, int32_t tick) override;
  std::optional<ActionRecord> Find(int64_t id) const override;
  std::optional<ActionRecord> FindNamed(const std::string& name) const override;
  std::vector<ActionRecord> All() const override;
  int64_t Count() const override { return static_cast<int64_t>(All().size()); }
  std::vector<ExperienceRecord> ExperiencesFrom(int64_t first_id,
                                                int64_t max) const override {
    return experiences_.Read(first_id, max);
  }
  int64_t NumExperiences() const override { return experiences_.Count(); }
  LibraryContent Content() const override;
  LibraryContent BeforeRun() const override;
  void BeginRun() override;
  void RollBackTo(int32_t tick) override;
  void BeginChange(const std::string& what) override;
  std::vector<StoreChange> Changes() const override;
  std::optional<StoreChange> ChangeOf(int64_t id) const override;
  std::optional<LibraryContent> ContentBefore(int64_t number) const override;
  int schema_version() const override { return 0; }

 private:
  struct Row {
    ActionRecord record;
    int32_t tick;
    int64_t change;  // its number, 0: of none
  };
  struct Change {
    StoreChange change;
    std::vector<ActionRecord> before;
  };
  bool IsReplaced(const ActionRecord& record) const;
  std::vector<int64_t> StoreRecords(std::span<const ActionRecord> records,
                                    int32_t tick);
  int64_t last_change() const {
    return changes_.empty() ? 0 : changes_.back().change.number;
  }

  std::vector<Row> rows_;  // by id
  std::vector<Change> changes_;
  MemoryExperiences experiences_;
};

}  // namespace cell::library
