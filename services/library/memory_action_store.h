#pragma once

#include "services/library/action_store.h"

namespace cell::library {

/// Keeps the actions in memory: for replay, evaluations and tests.
class MemoryActionStore final : public ActionStore {
 public:
  /// Holds these from before the run.
  explicit MemoryActionStore(std::span<const ActionRecord> records = {});

  std::vector<int64_t> Store(std::span<const ActionRecord> records,
                             int32_t tick) override;
  std::optional<ActionRecord> Find(int64_t id) const override;
  std::optional<ActionRecord> FindNamed(const std::string& name) const override;
  std::vector<ActionRecord> All() const override;
  std::vector<ActionRecord> BeforeRun() const override;
  int64_t Count() const override { return static_cast<int64_t>(All().size()); }
  void BeginRun() override;
  void RollBackTo(int32_t tick) override;
  void BeginChange(const std::string& what) override;
  std::vector<StoreChange> Changes() const override;
  std::optional<StoreChange> ChangeOf(int64_t id) const override;
  std::optional<std::vector<ActionRecord>> ContentBefore(
      int64_t number) const override;
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

  std::vector<Row> rows_;  // by id
  std::vector<Change> changes_;
};

}  // namespace cell::library
