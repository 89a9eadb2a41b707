#include "common/relational/undoing.h"

#include <algorithm>
#include <set>
#include <vector>

namespace cell {
namespace {

using Literals = std::vector<Literal>;

/// What the likeliest outcome changes of the action's arguments, whatever else
/// is the case.
Literals ChangesOf(const NdrRule& rule, size_t num_arguments) {
  Literals changes;
  const auto likeliest =
      std::ranges::max_element(rule.outcomes, {}, &Outcome::probability);
  if (likeliest == rule.outcomes.end()) return changes;
  const auto is_argument = [&](const Term& term) {
    return term.kind == Term::Kind::kVariable &&
           term.index < static_cast<int>(num_arguments);
  };
  for (const Effect& effect : likeliest->effects) {
    if (!effect.each.empty() || !effect.where.empty()) continue;
    std::ranges::copy_if(
        effect.then, std::back_inserter(changes), [&](const Literal& literal) {
          return std::ranges::all_of(literal.terms, is_argument);
        });
  }
  return changes;
}

/// What all rules of the action have in common of that.
Literals CommonChangesOf(const Action& action) {
  if (action.rules.empty()) return {};
  const size_t num_arguments = action.arguments.size();
  Literals common = ChangesOf(action.rules.front(), num_arguments);
  for (const NdrRule& rule : action.rules) {
    const Literals changes = ChangesOf(rule, num_arguments);
    std::erase_if(common, [&](const Literal& literal) {
      return std::ranges::count(changes, literal) == 0;
    });
  }
  return common;
}

}  // namespace

std::optional<int> DeriveUndone(const Action& action,
                                std::span<const Action> actions,
                                std::span<const Goal> goals) {
  std::set<int> goal_predicates;
  for (const Goal& goal : goals) {
    for (const Literal& literal : goal.literals) {
      goal_predicates.insert(literal.relation);
    }
  }
  const Literals changes = CommonChangesOf(action);
  const auto is_taken_back = [&](Literal literal) {
    literal.is_negated = true;
    return std::ranges::count(changes, literal) > 0;
  };
  std::optional<int> undone;
  for (size_t i = 0; i < actions.size(); ++i) {
    if (!action.TakesArgumentsOf(actions[i])) continue;
    Literals achieved = CommonChangesOf(actions[i]);
    std::erase_if(achieved, [&](const Literal& literal) {
      return literal.is_negated || !goal_predicates.contains(literal.relation);
    });
    if (achieved.empty() || !std::ranges::all_of(achieved, is_taken_back)) {
      continue;
    }
    if (undone) return std::nullopt;
    undone = static_cast<int>(i);
  }
  return undone;
}

}  // namespace cell
