#include "common/planning/packed_task.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cell::planning {
namespace {

constexpr double kSumTolerance = 1e-9;

}  // namespace

PackedTask::PackedTask(const GroundTask& task)
    : num_atoms_(static_cast<int>(task.atoms.size())),
      num_words_(std::max(1, (num_atoms_ + 63) / 64)) {
  if (task.initial.size() != task.atoms.size()) {
    throw std::invalid_argument("a task has " +
                                std::to_string(task.atoms.size()) +
                                " atoms, but the first truth of " +
                                std::to_string(task.initial.size()));
  }
  for (const GroundAction& action : task.actions) {
    actions_.push_back(Pack(action));
  }
  for (const Conjunction& goal : task.goals) goals_.push_back(Pack(goal));
}

PackedTask::Range PackedTask::PackMasks(const std::vector<Literal>& literals,
                                        bool are_changes) {
  const size_t begin = masks_.size();
  for (const Literal& literal : literals) {
    if (literal.atom < 0 || literal.atom >= num_atoms_) {
      throw std::invalid_argument("there is no atom " +
                                  std::to_string(literal.atom));
    }
    const auto word = static_cast<size_t>(literal.atom / 64);
    const uint64_t bit = uint64_t{1} << (literal.atom % 64);
    auto mask = std::find_if(
        masks_.begin() + static_cast<std::ptrdiff_t>(begin), masks_.end(),
        [&](const Mask& m) { return m.word == word; });
    if (mask == masks_.end()) mask = masks_.insert(mask, Mask{word, 0, 0});
    (literal.value ? mask->set : mask->clear) |= bit;
    // Of changes the last one counts; a condition may contradict itself.
    if (are_changes) (literal.value ? mask->clear : mask->set) &= ~bit;
  }
  return {begin, masks_.size()};
}

PackedTask::Condition PackedTask::Pack(const Conjunction& conjunction) {
  Condition condition;
  condition.masks = PackMasks(conjunction.literals, false);
  condition.clauses.begin = clauses_.size();
  for (const auto& clause : conjunction.clauses) {
    clauses_.push_back(PackMasks(clause, false));
  }
  condition.clauses.end = clauses_.size();
  return condition;
}

PackedTask::Effect PackedTask::Pack(const ConditionalEffect& effect) {
  const Condition when = Pack(effect.when);
  return {when, PackMasks(effect.then, true)};
}

PackedTask::Action PackedTask::Pack(const GroundAction& action) {
  Action packed{Pack(action.precondition), {outcomes_.size(), 0}, 1};
  for (const planning::Outcome& outcome : action.outcomes) {
    if (!(outcome.probability >= 0)) {
      throw std::invalid_argument("an outcome of " + action.name +
                                  " has the probability " +
                                  std::to_string(outcome.probability));
    }
    Outcome kept{outcome.probability, {effects_.size(), 0}};
    for (const ConditionalEffect& effect : outcome.effects) {
      effects_.push_back(Pack(effect));
    }
    kept.effects.end = effects_.size();
    packed.rest -= outcome.probability;
    if (outcome.probability > 0) outcomes_.push_back(kept);
  }
  packed.outcomes.end = outcomes_.size();
  if (packed.rest < -kSumTolerance) {
    throw std::invalid_argument("the outcomes of " + action.name +
                                " sum to more than 1");
  }
  if (packed.rest < kSumTolerance) packed.rest = 0;
  return packed;
}

bool PackedTask::Holds(const Condition& condition, Bits state) const {
  for (size_t i = condition.masks.begin; i < condition.masks.end; ++i) {
    const Mask& mask = masks_[i];
    const uint64_t word = state[mask.word];
    if ((word & mask.set) != mask.set || (word & mask.clear) != 0) return false;
  }
  for (size_t c = condition.clauses.begin; c < condition.clauses.end; ++c) {
    bool holds = false;
    for (size_t i = clauses_[c].begin; i < clauses_[c].end && !holds; ++i) {
      const uint64_t word = state[masks_[i].word];
      holds = ((word & masks_[i].set) | (~word & masks_[i].clear)) != 0;
    }
    if (!holds) return false;
  }
  return true;
}

void PackedTask::Apply(const Outcome& outcome, Bits before,
                       std::span<uint64_t> after) const {
  for (size_t e = outcome.effects.begin; e < outcome.effects.end; ++e) {
    const Effect& effect = effects_[e];
    if (!Holds(effect.when, before)) continue;
    for (size_t i = effect.changes.begin; i < effect.changes.end; ++i) {
      uint64_t& word = after[masks_[i].word];
      word = (word & ~masks_[i].clear) | masks_[i].set;
    }
  }
}

bool PackedTask::IsGoal(Bits state) const {
  return std::ranges::any_of(
      goals_, [&](const Condition& goal) { return Holds(goal, state); });
}

void PackedTask::Expand(Bits state, Expansion* expansion) const {
  for (size_t a = 0; a < actions_.size(); ++a) {
    const Action& action = actions_[a];
    if (!Holds(action.precondition, state)) continue;
    expansion->BeginChoice(static_cast<int>(a));
    for (size_t o = action.outcomes.begin; o < action.outcomes.end; ++o) {
      Apply(outcomes_[o], state,
            expansion->AddOutcome(outcomes_[o].probability, state));
    }
    if (action.rest > 0) expansion->AddOutcome(action.rest, state);
  }
}

}  // namespace cell::planning
