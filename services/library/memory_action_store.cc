#include "services/library/memory_action_store.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/actions/build_version.h"

namespace cell::library {

MemoryActionStore::MemoryActionStore(std::span<const ActionRecord> records)
    : experiences_({}, 0) {
  StoreRecords(records, kBeforeRun);
}

MemoryActionStore::MemoryActionStore(const LibraryContent& content)
    : experiences_(content.experiences, content.last_experience) {
  StoreRecords(content.actions, kBeforeRun);
  for (size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].record.id = content.actions[i].id;
  }
}

StoredIds MemoryActionStore::Apply(const StoreEdit& edit, int32_t tick) {
  for (const int64_t id : edit.removed_experiences) {
    if (!experiences_.Has(id)) {
      throw std::invalid_argument("there is no experience " +
                                  std::to_string(id));
    }
  }
  StoredIds ids{StoreRecords(edit.records, tick), {}};
  for (const int64_t id : edit.removed_experiences) {
    experiences_.Remove(id, tick, last_change());
  }
  for (const ExperienceRecord& experience : edit.experiences) {
    ids.experiences.push_back(
        experiences_.Add(experience, tick, last_change()));
  }
  return ids;
}

std::vector<int64_t> MemoryActionStore::StoreRecords(
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
    rows_.push_back({record, tick, last_change()});
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

LibraryContent MemoryActionStore::Content() const {
  return {All(), Experiences(), experiences_.last_id()};
}

LibraryContent MemoryActionStore::BeforeRun() const {
  MemoryActionStore before;
  std::ranges::copy_if(rows_, std::back_inserter(before.rows_),
                       [](const Row& row) { return row.tick == kBeforeRun; });
  return {before.All(), experiences_.BeforeRun(), experiences_.last_id()};
}

void MemoryActionStore::BeginRun() {
  std::erase_if(rows_,
                [this](const Row& row) { return IsReplaced(row.record); });
  for (Row& row : rows_) row.tick = kBeforeRun;
  experiences_.BeginRun();
}

void MemoryActionStore::RollBackTo(int32_t tick) {
  while (!rows_.empty() && rows_.back().tick >= tick) rows_.pop_back();
  experiences_.RollBackTo(tick);
}

void MemoryActionStore::BeginChange(const std::string& what) {
  std::vector<ActionRecord> before = All();
  if (!changes_.empty() && changes_.back().before == before &&
      !experiences_.HasChangedIn(last_change())) {
    changes_.back().change.what = what;
    return;
  }
  changes_.push_back(
      {{last_change() + 1, what, BuildVersion()}, std::move(before)});
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

std::optional<LibraryContent> MemoryActionStore::ContentBefore(
    int64_t number) const {
  for (const Change& change : changes_) {
    if (change.change.number != number) continue;
    return LibraryContent{change.before, experiences_.BeforeChange(number),
                          experiences_.last_id()};
  }
  return std::nullopt;
}

}  // namespace cell::library
