#include "services/library/memory_action_store.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/actions/build_version.h"

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
    rows_.push_back(
        {record, tick, changes_.empty() ? 0 : changes_.back().change.number});
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

std::vector<ActionRecord> MemoryActionStore::BeforeRun() const {
  MemoryActionStore before;
  std::ranges::copy_if(rows_, std::back_inserter(before.rows_),
                       [](const Row& row) { return row.tick == kBeforeRun; });
  return before.All();
}

void MemoryActionStore::BeginRun() {
  std::erase_if(rows_,
                [this](const Row& row) { return IsReplaced(row.record); });
  for (Row& row : rows_) row.tick = kBeforeRun;
}

void MemoryActionStore::RollBackTo(int32_t tick) {
  while (!rows_.empty() && rows_.back().tick >= tick) rows_.pop_back();
}

void MemoryActionStore::BeginChange(const std::string& what) {
  std::vector<ActionRecord> before = All();
  if (!changes_.empty() && changes_.back().before == before) {
    changes_.back().change.what = what;
    return;
  }
  const int64_t number =
      changes_.empty() ? 1 : changes_.back().change.number + 1;
  changes_.push_back({{number, what, BuildVersion()}, std::move(before)});
  if (changes_.size() > kMaxChanges) changes_.erase(changes_.begin());
}

std::vector<StoreChange> MemoryActionStore::Changes() const {
  std::vector<StoreChange> changes;
  for (const Change& change : changes_) changes.push_back(change.change);
  return changes;
}

std::optional<StoreChange> MemoryActionStore::ChangeOf(int64_t id) const {
  const auto row =
      std::ranges::find(rows_, id, [](const Row& r) { return r.record.id; });
  if (row == rows_.end()) return std::nullopt;
  for (const Change& change : changes_) {
    if (change.change.number == row->change) return change.change;
  }
  return std::nullopt;
}

std::optional<std::vector<ActionRecord>> MemoryActionStore::ContentBefore(
    int64_t number) const {
  for (const Change& change : changes_) {
    if (change.change.number == number) return change.before;
  }
  return std::nullopt;
}

}  // namespace cell::library
