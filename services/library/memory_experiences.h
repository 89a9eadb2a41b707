#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "common/experiences/experience_record.h"

namespace cell::library {

/// The experiences of a MemoryActionStore: what SqliteExperiences does, in
/// memory.
class MemoryExperiences {
 public:
  /// Holds these, with their ids, from before the run.
  /// @param last_id  the highest id given so far
  MemoryExperiences(std::span<const ExperienceRecord> experiences,
                    int64_t last_id);

  /// Of the change with this number, as the removals.
  int64_t Add(const ExperienceRecord& experience, int32_t tick, int64_t change);
  bool Has(int64_t id) const;
  /// Of one that is there.
  void Remove(int64_t id, int32_t tick, int64_t change);

  std::vector<ExperienceRecord> Read(int64_t first_id, int64_t max) const;
  std::vector<ExperienceRecord> BeforeRun() const;
  std::vector<ExperienceRecord> BeforeChange(int64_t number) const;
  int64_t Count() const;
  int64_t last_id() const;
  /// True if something was stored or removed by the change.
  bool HasChangedIn(int64_t number) const;

  void BeginRun();
  void RollBackTo(int32_t tick);

 private:
  struct Removal {
    int32_t tick;
    int64_t change;
  };
  struct Row {
    ExperienceRecord experience;
    int32_t tick;
    int64_t change;
    std::optional<Removal> removal;
  };
  std::vector<ExperienceRecord> Select(
      const std::function<bool(const Row&)>& is_wanted) const;

  std::vector<Row> rows_;  // by id
  int64_t first_last_id_;
};

}  // namespace cell::library
