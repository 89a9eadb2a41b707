#include "services/library/memory_experiences.h"

#include <algorithm>

#include "services/library/action_store.h"

namespace cell::library {

MemoryExperiences::MemoryExperiences(
    std::span<const ExperienceRecord> experiences, int64_t last_id)
    : first_last_id_(last_id) {
  for (const ExperienceRecord& experience : experiences) {
    rows_.push_back({experience, kBeforeRun, 0, std::nullopt});
  }
}

int64_t MemoryExperiences::Add(const ExperienceRecord& experience, int32_t tick,
                               int64_t change) {
  const int64_t id = last_id() + 1;
  rows_.push_back({experience, tick, change, std::nullopt});
  rows_.back().experience.id = id;
  return id;
}

bool MemoryExperiences::Has(int64_t id) const {
  return std::ranges::any_of(rows_, [&](const Row& row) {
    return row.experience.id == id && !row.removal;
  });
}

void MemoryExperiences::Remove(int64_t id, int32_t tick, int64_t change) {
  for (Row& row : rows_) {
    if (row.experience.id == id) row.removal = Removal{tick, change};
  }
}

std::vector<ExperienceRecord> MemoryExperiences::Select(
    const std::function<bool(const Row&)>& is_wanted) const {
  std::vector<ExperienceRecord> selected;
  for (const Row& row : rows_) {
    if (is_wanted(row)) selected.push_back(row.experience);
  }
  return selected;
}

std::vector<ExperienceRecord> MemoryExperiences::Read(int64_t first_id,
                                                      int64_t max) const {
  int64_t num_read = 0;
  return Select([&](const Row& row) {
    return row.experience.id >= first_id && !row.removal && num_read++ < max;
  });
}

std::vector<ExperienceRecord> MemoryExperiences::BeforeRun() const {
  return Select([](const Row& row) {
    return row.tick == kBeforeRun &&
           (!row.removal || row.removal->tick > kBeforeRun);
  });
}

std::vector<ExperienceRecord> MemoryExperiences::BeforeChange(
    int64_t number) const {
  return Select([&](const Row& row) {
    return row.change < number &&
           (!row.removal || row.removal->change >= number);
  });
}

int64_t MemoryExperiences::Count() const {
  return std::ranges::count_if(rows_,
                               [](const Row& row) { return !row.removal; });
}

int64_t MemoryExperiences::last_id() const {
  return rows_.empty() ? first_last_id_
                       : std::max(first_last_id_, rows_.back().experience.id);
}

bool MemoryExperiences::HasChangedIn(int64_t number) const {
  return std::ranges::any_of(rows_, [&](const Row& row) {
    return row.change == number ||
           (row.removal && row.removal->change == number);
  });
}

void MemoryExperiences::BeginRun() {
  for (Row& row : rows_) {
    row.tick = kBeforeRun;
    if (row.removal) row.removal->tick = kBeforeRun;
  }
}

void MemoryExperiences::RollBackTo(int32_t tick) {
  std::erase_if(rows_, [&](const Row& row) { return row.tick >= tick; });
  for (Row& row : rows_) {
    if (row.removal && row.removal->tick >= tick) row.removal.reset();
  }
}

}  // namespace cell::library
