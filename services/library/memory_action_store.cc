#include "services/library/memory_action_store.h"

#include <algorithm>

namespace cell::library {

MemoryActionStore::MemoryActionStore(std::span<const ActionRecord> records) {
  Store(records, kBeforeRun);
}

std::vector<int64_t> MemoryActionStore::Store(
    std::span<const ActionRecord> records, int32_t tick) {
  const size_t num_before = records_.size();
  std::vector<int64_t> ids;
  for (const ActionRecord& record : records) {
    if (FindNamed(record.name)) {
      records_.resize(num_before);
      throw std::invalid_argument("an action '" + record.name +
                                  "' is there already");
    }
    records_.push_back(record);
    records_.back().id = static_cast<int64_t>(records_.size());
    ids.push_back(records_.back().id);
  }
  ticks_.resize(records_.size(), tick);
  return ids;
}

std::optional<ActionRecord> MemoryActionStore::Find(int64_t id) const {
  if (id < 1 || id > static_cast<int64_t>(records_.size())) return std::nullopt;
  return records_[static_cast<size_t>(id) - 1];
}

std::optional<ActionRecord> MemoryActionStore::FindNamed(
    const std::string& name) const {
  const auto it = std::find_if(
      records_.begin(), records_.end(),
      [&](const ActionRecord& record) { return record.name == name; });
  return it == records_.end() ? std::nullopt : std::optional(*it);
}

void MemoryActionStore::BeginRun() {
  ticks_.assign(records_.size(), kBeforeRun);
}

void MemoryActionStore::RollBackTo(int32_t tick) {
  while (!ticks_.empty() && ticks_.back() >= tick) {
    ticks_.pop_back();
    records_.pop_back();
  }
}

}  // namespace cell::library
