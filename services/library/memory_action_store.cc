#include "services/library/memory_action_store.h"

#include <algorithm>

namespace cell::library {

MemoryActionStore::MemoryActionStore(std::span<const ActionRecord> records) {
  Store(records, kBeforeRun);
}

std::vector<int64_t> MemoryActionStore::Store(
    std::span<const ActionRecord> records, int32_t tick) {
  const size_t num_before = rows_.size();
  std::vector<int64_t> ids;
  for (const ActionRecord& record : records) {
    const auto known = FindNamed(record.name);
    if (known && known->version >= record.version) {
      rows_.resize(num_before);
      throw std::invalid_argument("an action '" + record.name +
                                  "' already exists");
    }
    ids.push_back(rows_.empty() ? 1 : rows_.back().record.id + 1);
    rows_.push_back({record, tick});
    rows_.back().record.id = ids.back();
  }
  return ids;
}

std::optional<ActionRecord> MemoryActionStore::Find(int64_t id) const {
  const auto it = std::ranges::find(
      rows_, id, [](const Row& row) { return row.record.id; });
  return it == rows_.end() ? std::nullopt : std::optional(it->record);
}

std::optional<ActionRecord> MemoryActionStore::FindNamed(
    const std::string& name) const {
  const auto it =
      std::find_if(rows_.rbegin(), rows_.rend(),
                   [&](const Row& row) { return row.record.name == name; });
  return it == rows_.rend() ? std::nullopt : std::optional(it->record);
}

bool MemoryActionStore::IsReplaced(const ActionRecord& record) const {
  return FindNamed(record.name)->id != record.id;
}

std::vector<ActionRecord> MemoryActionStore::All() const {
  std::vector<ActionRecord> latest;
  for (const Row& row : rows_) {
    if (!IsReplaced(row.record)) latest.push_back(row.record);
  }
  return latest;
}

void MemoryActionStore::BeginRun() {
  const std::vector<ActionRecord> latest = All();
  rows_.clear();
  for (const ActionRecord& record : latest) {
    rows_.push_back({record, kBeforeRun});
  }
}

void MemoryActionStore::RollBackTo(int32_t tick) {
  while (!rows_.empty() && rows_.back().tick >= tick) rows_.pop_back();
}

}  // namespace cell::library
