#include "common/experiences/effects_on_others.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/experiences/condition_search.h"
#include "common/experiences/literal_space.h"
#include "common/experiences/own_changes.h"

namespace cell {
namespace {

std::string FreeVariableName(const rules::Rule& rule) {
  for (char name = 'P'; name <= 'W'; ++name) {
    bool is_used = false;
    for (int i = 0; i < rule.num_variables(); ++i) {
      is_used |= rule.VariableName(i) == std::string(1, name);
    }
    if (!is_used) return std::string(1, name);
  }
  return "Other";
}

/// Literals of the variable, of the arguments, and of landmarks.
std::vector<rules::Literal> CandidatesFor(const rules::Rule& rule,
                                          std::span<const int> landmarks,
                                          const VariableTypes& types,
                                          const rules::World& world) {
  std::vector<rules::Term> terms = {
      {rules::Term::Kind::kVariable, rule.num_variables()}};
  for (const rules::Term& term : ArgumentTerms(rule)) terms.push_back(term);
  terms.push_back({rules::Term::Kind::kAny, 0});
  std::vector<rules::Literal> of_variable;
  std::vector<rules::Literal> others;
  ForEachLiteral(terms, world, [&](const rules::Literal& literal) {
    if (types.IsNamedBy(literal)) {
      of_variable.push_back(literal);
    } else if (!NamesNothing(literal) ||
               std::ranges::count(landmarks, literal.symbol) > 0) {
      others.push_back(literal);
    }
  });
  of_variable.insert(of_variable.end(), others.begin(), others.end());
  return of_variable;
}

using Change = std::pair<int, bool>;  // symbol of an atom, its truth after it

/// Changes that are not OwnChanges().
std::set<Change> ChangesOfOthers(std::span<const BoundExperience> experiences,
                                 const RuleWorld& world) {
  std::set<Change> changes;
  for (const BoundExperience& bound : experiences) {
    const rules::WorldState& after = bound.experience->after;
    ForEachDifference(OwnChanges(*bound.experience, world).after, after,
                      *world.world(), [&](int symbol, int place) {
                        changes.emplace(symbol,
                                        rules::World::Get(after, place));
                      });
  }
  return changes;
}

/// All atoms with the variable once and arguments else, true and false.
std::vector<rules::Literal> PossibleChanges(const rules::Rule& rule,
                                            const RuleWorld& world) {
  const int variable = rule.num_variables();
  std::vector<rules::Term> terms = {{rules::Term::Kind::kVariable, variable}};
  for (const rules::Term& term : ArgumentTerms(rule)) terms.push_back(term);
  std::vector<rules::Literal> changes;
  ForEachLiteral(terms, *world.world(), [&](const rules::Literal& literal) {
    const auto num = std::ranges::count(literal.terms, terms.front());
    if (num == 1 && world.PredicateOf(literal.symbol)) {
      changes.push_back(literal);
    }
  });
  return changes;
}

std::vector<BoundExperience> ExplainedBy(
    const rules::Outcome& outcome, const rules::Rule& rule,
    std::span<const rules::Experience> experiences,
    const rules::QuantifiedAtoms& atoms, const RuleWorld& world) {
  std::vector<BoundExperience> explained;
  for (const rules::Experience& e : experiences) {
    if (e.act.action != rule.action) continue;
    const auto binding =
        rules::Bind(rule, e.act.arguments, e.before, *world.world());
    if (!binding) continue;
    const rules::Outcome own{outcome.probability, outcome.changes};
    if (rules::Apply(own, *binding, e.before, *world.world()) ==
        OwnChanges(e, world).after) {
      explained.push_back({&e, *binding, atoms.TrueIn(e.before)});
    }
  }
  return explained;
}

}  // namespace

void AddEffectsOnOthers(std::span<const rules::Experience> experiences,
                        std::span<const int> landmarks, const RuleWorld& world,
                        rules::Rule* rule) {
  const rules::QuantifiedAtoms atoms(world.world());
  const std::string variable = FreeVariableName(*rule);
  const VariableTypes types(world, rule->num_variables());
  const auto candidates =
      CandidatesFor(*rule, landmarks, types, *world.world());
  for (rules::Outcome& outcome : rule->outcomes) {
    if (outcome.changes.empty()) continue;
    const auto explained =
        ExplainedBy(outcome, *rule, experiences, atoms, world);
    const std::set<Change> changes = ChangesOfOthers(explained, world);
    for (const rules::Literal& change : PossibleChanges(*rule, world)) {
      const bool is_true = change.comparison == rules::Comparison::kTrue;
      if (!changes.contains({change.symbol, is_true})) continue;
      ConditionSearch search(explained, change, candidates, landmarks, types,
                             atoms, *world.world());
      for (auto& where : search.Run()) {
        outcome.each.push_back({variable, std::move(where), change});
      }
    }
  }
}

}  // namespace cell
