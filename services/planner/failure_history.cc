#include "services/planner/failure_history.h"

#include <algorithm>

namespace cell::planner {
namespace {

bool Concerns(const GroundAction& action, int object) {
  return std::find(action.arguments.begin(), action.arguments.end(), object) !=
         action.arguments.end();
}

}  // namespace

void FailureHistory::Add(const GroundAction& action, const State& before,
                         const std::string& reason) {
  const auto [it, is_new] = entries_.try_emplace(action, Entry{before, 0, ""});
  if (!is_new && !IsSame(action, it->second.before, before))
    it->second.count = 0;
  it->second.before = before;
  it->second.reason = reason;
  ++it->second.count;
}

void FailureHistory::Update(const State& now) {
  std::erase_if(entries_, [&](const auto& entry) {
    return !IsSame(entry.first, entry.second.before, now);
  });
}

void FailureHistory::ForgetAbout(int object) {
  std::erase_if(entries_, [&](const auto& entry) {
    return Concerns(entry.first, object);
  });
}

std::set<GroundAction> FailureHistory::Blocked() const {
  std::set<GroundAction> blocked;
  for (const auto& [action, entry] : entries_) {
    if (entry.count >= max_attempts_) blocked.insert(action);
  }
  return blocked;
}

const FailureHistory::Entry* FailureHistory::Of(
    const GroundAction& action) const {
  const auto it = entries_.find(action);
  return it == entries_.end() ? nullptr : &it->second;
}

bool FailureHistory::IsSame(const GroundAction& action, const State& before,
                            const State& now) const {
  for (int index = 0; index < now.num_atoms(); ++index) {
    const Truth a = before.Get(index);
    const Truth b = now.Get(index);
    if (a == b || a == Truth::kUnknown || b == Truth::kUnknown) continue;
    const GroundAtom atom = vocabulary_->Atom(index);
    const auto& report = vocabulary_->predicates()[atom.predicate].report;
    if (report == Predicate::Report::kHeld) continue;
    const bool counts =
        !report || std::any_of(atom.objects.begin(), atom.objects.end(),
                               [&](int o) { return Concerns(action, o); });
    if (counts) return false;
  }
  return true;
}

}  // namespace cell::planner
