#include "services/planner/unexplained_changes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace cell::planner {
namespace {

/// If nothing in an episode is recognised, the first ones are enough.
constexpr size_t kMaxChanges = 1000;
/// That a change may still belong to.
constexpr size_t kMaxActions = 16;

}  // namespace

UnexplainedChanges::UnexplainedChanges(
    std::shared_ptr<const Vocabulary> vocabulary, std::span<const Goal> goals,
    const Params& params, bool has_joined_late)
    : vocabulary_(std::move(vocabulary)),
      params_(params),
      has_joined_late_(has_joined_late) {
  for (const Goal& goal : goals) {
    for (const Literal& literal : goal.literals) {
      if (!literal.is_static) goal_predicates_.insert(literal.relation);
    }
  }
}

void UnexplainedChanges::Update(const SensedState& sensed) {
  if (latest_ && sensed.utime <= latest_->utime) return;
  if (latest_) {
    Add(ChangesSince(sensed));
    return;
  }
  latest_ = sensed;
  if (has_joined_late_) Add(Found(sensed));
}

UnexplainedChanges::Change UnexplainedChanges::Found(
    const SensedState& sensed) const {
  Change change{sensed.key_frame, sensed.utime, {}, true};
  for (int atom = 0; atom < sensed.state.num_atoms(); ++atom) {
    if (sensed.state.Get(atom) == Truth::kTrue &&
        goal_predicates_.contains(vocabulary_->Atom(atom).predicate)) {
      change.atoms.emplace_back(atom, true);
    }
  }
  return change;
}

UnexplainedChanges::Change UnexplainedChanges::ChangesSince(
    const SensedState& sensed) {
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
  return change;
}

void UnexplainedChanges::Add(Change change) {
  for (const DoneAction& action : actions_) Account(action, change);
  if (!change.atoms.empty() && changes_.size() < kMaxChanges) {
    changes_.push_back(std::move(change));
  }
}

bool UnexplainedChanges::IsDuring(const DoneAction& action,
                                  const Change& change) const {
  // From the state that the pick-up has made to what settles afterwards; a
  // state without a key frame of its own goes by its time.
  const bool is_within = change.key_frame >= action.pick_key_frame &&
                         change.key_frame <= action.place_key_frame;
  const bool is_about = change.utime >= action.pick_utime &&
                        change.utime <= action.utime + params_.settle_us;
  return is_within || is_about;
}

bool UnexplainedChanges::Explains(const DoneAction& action, int atom) const {
  const GroundAtom ground = vocabulary_->Atom(atom);
  return !goal_predicates_.contains(ground.predicate) ||
         std::ranges::any_of(ground.objects, [&](int object) {
           return std::ranges::count(action.objects, object) > 0;
         });
}

void UnexplainedChanges::Account(const DoneAction& action,
                                 Change& change) const {
  if (!IsDuring(action, change)) return;
  std::erase_if(change.atoms,
                [&](const auto& atom) { return Explains(action, atom.first); });
}

void UnexplainedChanges::Update(const DoneAction& action) {
  for (Change& change : changes_) Account(action, change);
  std::erase_if(changes_,
                [](const Change& change) { return change.atoms.empty(); });
  actions_.push_back(action);
  if (actions_.size() > kMaxActions) actions_.pop_front();
}

std::vector<std::string> UnexplainedChanges::TakeAll() {
  return TakeOverdue(std::numeric_limits<int64_t>::max());
}

std::vector<std::string> UnexplainedChanges::TakeOverdue(int64_t now) {
  std::vector<std::string> texts;
  std::erase_if(changes_, [&](const Change& change) {
    const bool is_overdue = now - change.utime > params_.patience_us;
    if (is_overdue) texts.push_back(Describe(change));
    return is_overdue;
  });
  return texts;
}

std::string UnexplainedChanges::Describe(const Change& change) const {
  std::vector<std::string> literals;
  for (const auto& [atom, is_true] : change.atoms) {
    literals.push_back((is_true ? "" : "not ") + vocabulary_->AtomName(atom));
  }
  const double seconds = 1e-6 * static_cast<double>(change.utime);
  if (change.is_found) {
    return fmt::format(
        "Found at {:.2f} s, done by an unknown agent before the planner "
        "started: {}",
        seconds, fmt::join(literals, ", "));
  }
  return fmt::format(
      "No recognised action explains what changed at {:.2f} s: {}", seconds,
      fmt::join(literals, ", "));
}

}  // namespace cell::planner
