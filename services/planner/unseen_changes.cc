#include "services/planner/unseen_changes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cell {
namespace {

/// Of an episode that nobody recognises anything in, the first ones will do.
constexpr size_t kMaxChanges = 1000;
/// That a change may still belong to.
constexpr size_t kMaxActions = 16;

}  // namespace

void UnseenChanges::Take(const SensedState& sensed) {
  if (latest_ && sensed.utime <= latest_->utime) return;
  if (!latest_) {
    latest_ = sensed;
    return;
  }
  Change change{sensed.key_frame, sensed.utime, {}};
  for (int atom = 0; atom < sensed.state.num_atoms(); ++atom) {
    const Truth now = sensed.state.Get(atom);
    if (now == Truth::kUnknown) continue;
    const Truth before = latest_->state.Get(atom);
    if (before != Truth::kUnknown && before != now) {
      change.atoms.emplace_back(atom, now == Truth::kTrue);
    }
    latest_->state.Set(atom, now);  // the last that was known of it
  }
  latest_->utime = sensed.utime;
  const bool is_explained =
      std::any_of(actions_.begin(), actions_.end(),
                  [&](const auto& action) { return Explains(action, change); });
  if (!change.atoms.empty() && !is_explained && changes_.size() < kMaxChanges) {
    changes_.push_back(std::move(change));
  }
}

bool UnseenChanges::Explains(const DoneAction& action,
                             const Change& change) const {
  // From the state that the pick-up has made to what settles afterwards; a
  // state without a key frame of its own goes by its time.
  const bool is_within = change.key_frame >= action.pick_key_frame &&
                         change.key_frame <= action.place_key_frame;
  const bool is_about = change.utime >= action.pick_utime &&
                        change.utime <= action.utime + params_.settle_us;
  return is_within || is_about;
}

void UnseenChanges::Take(const DoneAction& action) {
  std::erase_if(changes_,
                [&](const Change& change) { return Explains(action, change); });
  actions_.push_back(action);
  if (actions_.size() > kMaxActions) actions_.pop_front();
}

std::vector<std::string> UnseenChanges::TakeOverdue(int64_t now) {
  std::vector<std::string> texts;
  std::erase_if(changes_, [&](const Change& change) {
    const bool is_overdue = now - change.utime > params_.patience_us;
    if (is_overdue) texts.push_back(Tell(change));
    return is_overdue;
  });
  return texts;
}

std::string UnseenChanges::Tell(const Change& change) const {
  std::vector<std::string> literals;
  for (const auto& [atom, is_true] : change.atoms) {
    literals.push_back((is_true ? "" : "not ") +
                       domain_.vocabulary().AtomName(atom));
  }
  return fmt::format(
      "No action was recognised that has made it so, at {:.2f} s: {}",
      1e-6 * static_cast<double>(change.utime), fmt::join(literals, ", "));
}

}  // namespace cell
