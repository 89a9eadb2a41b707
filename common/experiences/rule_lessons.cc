#include "common/experiences/rule_lessons.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "common/experiences/effects_on_others.h"
#include "common/experiences/literal_space.h"
#include "common/rules/learning/learner.h"

namespace cell {
namespace {

using rules::Comparison;
using rules::Experience;

/// One in so many is taken for sensed wrongly.
constexpr std::ptrdiff_t kSuccessesPerException = 20;
/// Of an action with so many experiences, one or two alone make no rule.
constexpr int kManyExperiences = 40;
constexpr int kFewExperiences = 2;

std::vector<rules::Term> TermsOf(const rules::Rule& rule,
                                 const rules::World& world) {
  std::vector<rules::Term> terms = ArgumentTerms(rule);
  for (int i = 0; i < world.num_constants(); ++i) {
    terms.push_back({rules::Term::Kind::kObject, i});
  }
  terms.push_back({rules::Term::Kind::kAny, 0});
  return terms;
}

/// True if `a` holds wherever `b` does, by its words: "not On(X, _)" says more
/// than "not On(X, a)", and "On(X, a)" more than "On(X, _)".
bool Follows(const rules::Literal& a, const rules::Literal& b) {
  if (a == b || a.symbol != b.symbol || a.comparison != b.comparison) {
    return false;
  }
  const rules::Literal& general = a.comparison == Comparison::kTrue ? a : b;
  const rules::Literal& special = a.comparison == Comparison::kTrue ? b : a;
  for (size_t i = 0; i < a.terms.size(); ++i) {
    if (general.terms[i] != special.terms[i] &&
        general.terms[i].kind != rules::Term::Kind::kAny) {
      return false;
    }
  }
  return true;
}

bool NamesAnArgument(const rules::Literal& literal) {
  return std::ranges::any_of(literal.terms, [](const rules::Term& term) {
    return term.kind == rules::Term::Kind::kVariable;
  });
}

/// All objects that the types of the rule's action allow.
std::vector<std::vector<int>> BindingsOf(const rules::Rule& rule,
                                         const rules::WorldState& state,
                                         const rules::World& world) {
  std::vector<std::vector<int>> bindings;
  for (const rules::GroundAct& act : rules::GroundActs(world, state)) {
    if (act.action == rule.action) bindings.push_back(act.arguments);
  }
  return bindings;
}

/// True if the literal is about one argument, and its predicate has been both
/// true and false of some object: what was never seen to change of an action's
/// own objects may change nevertheless, as it does of others.
bool ChangesOfOthers(const rules::Literal& literal,
                     std::span<const Experience> experiences,
                     const rules::World& world) {
  if (literal.terms.size() != 1 || !NamesAnArgument(literal)) return false;
  const int first = world.first(literal.symbol);
  for (int i = 0; i < world.num_places(literal.symbol); ++i) {
    bool is_ever_true = false, is_ever_false = false;
    for (const Experience& e : experiences) {
      for (const auto* state : {&e.before, &e.after}) {
        const bool is_true = rules::World::Get(*state, first + i);
        is_ever_true |= is_true;
        is_ever_false |= !is_true;
      }
    }
    if (is_ever_true && is_ever_false) return true;
  }
  return false;
}

/// True if the literal does not hold before some experience, for some objects
/// of the action, or ChangesOfOthers().
bool IsTelling(const rules::Literal& literal,
               const std::vector<std::vector<int>>& bindings,
               std::span<const Experience> experiences,
               const rules::World& world) {
  if (ChangesOfOthers(literal, experiences, world)) return true;
  return std::ranges::any_of(experiences, [&](const Experience& e) {
    return std::ranges::any_of(bindings, [&](const auto& binding) {
      return !rules::Holds(literal, binding, e.before, world) ||
             !rules::Holds(literal, binding, e.after, world);
    });
  });
}

/// Without rules of few experiences among many of the action.
void DropRare(std::vector<int>* counts, rules::NdrRules* rules) {
  std::map<int, int> of_action;
  for (size_t i = 0; i < counts->size(); ++i) {
    of_action[rules->rules[i].action] += (*counts)[i];
  }
  for (size_t i = counts->size(); i-- > 0;) {
    if ((*counts)[i] > kFewExperiences ||
        of_action[rules->rules[i].action] < kManyExperiences) {
      continue;
    }
    const auto at = static_cast<std::ptrdiff_t>(i);
    rules->rules.erase(rules->rules.begin() + at);
    counts->erase(counts->begin() + at);
  }
}

void MakeUnsure(const std::vector<int>& counts, rules::NdrRules* rules) {
  for (size_t i = 0; i < rules->rules.size(); ++i) {
    rules::Rule& rule = rules->rules[i];
    const double share = counts[i] / (counts[i] + 1.0);
    double sum = 0;
    for (rules::Outcome& outcome : rule.outcomes) {
      outcome.probability *= share;
      sum += outcome.probability;
    }
    rule.noise = 1 - sum;
  }
}

/// Those there are, and the reversed ones of actions that were never done.
std::vector<Experience> WithReversed(std::span<const Experience> experiences,
                                     const RuleWorld& world) {
  std::vector<Experience> all(experiences.begin(), experiences.end());
  std::set<int> known;
  for (const Experience& e : experiences) known.insert(e.act.action);
  for (const Action& action : world.actions()) {
    const int symbol = *world.world()->symbols().Find(action.name);
    if (!action.undoes || known.contains(symbol)) continue;
    const std::string& undone =
        world.actions()[static_cast<size_t>(*action.undoes)].name;
    for (const Experience& e : experiences) {
      if (world.world()->symbols()[e.act.action].name == undone) {
        all.push_back(Reversed(e, symbol));
      }
    }
  }
  return all;
}

}  // namespace

rules::Experience OwnChanges(const rules::Experience& experience,
                             const RuleWorld& world) {
  const rules::World& w = *world.world();
  Experience own = experience;
  const auto is_own = [&](int object) {
    return std::ranges::count(experience.act.arguments, object) > 0;
  };
  for (size_t s = 0; s < w.symbols().all().size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (w.symbols()[symbol].kind != rules::Symbol::Kind::kPrimitive) continue;
    for (int i = 0; i < w.num_places(symbol); ++i) {
      const int place = w.first(symbol) + i;
      const bool before = rules::World::Get(experience.before, place);
      if (before != rules::World::Get(experience.after, place) &&
          !std::ranges::all_of(w.ObjectsAt(symbol, place), is_own)) {
        rules::World::Set(&own.after, place, before);
      }
    }
  }
  return own;
}

rules::Experience Reversed(const rules::Experience& experience, int action) {
  return {
      experience.after, {action, experience.act.arguments}, experience.before};
}

void Specialize(std::span<const rules::Experience> experiences,
                std::span<const int> landmarks, const rules::World& world,
                rules::Rule* rule, int num_for_others) {
  std::vector<const Experience*> successes;
  for (const Experience& e : experiences) {
    if (e.act.action == rule->action && e.before != e.after &&
        rules::Bind(*rule, e.act.arguments, e.before, world)) {
      successes.push_back(&e);
    }
  }
  if (successes.empty()) return;
  const auto bindings = BindingsOf(*rule, successes.front()->before, world);
  std::vector<rules::Literal> shared;
  ForEachLiteral(
      TermsOf(*rule, world), world, [&](const rules::Literal& literal) {
        if (!NamesAnArgument(literal) &&
            std::ssize(successes) < num_for_others) {
          return;
        }
        if (NamesNothing(literal) &&
            std::ranges::count(landmarks, literal.symbol) == 0) {
          return;
        }
        const auto num_exceptions =
            std::ranges::count_if(successes, [&](const Experience* e) {
              return !rules::Holds(literal, e->act.arguments, e->before, world);
            });
        const bool is_shared =
            num_exceptions * kSuccessesPerException <= std::ssize(successes);
        if (is_shared && IsTelling(literal, bindings, experiences, world)) {
          shared.push_back(literal);
        }
      });
  for (const rules::Literal& literal : rule->context) {
    if (std::ranges::count(shared, literal) == 0) shared.push_back(literal);
  }
  rule->context.clear();
  for (const rules::Literal& literal : shared) {
    if (std::ranges::none_of(shared, [&](const rules::Literal& other) {
          return Follows(literal, other);
        })) {
      rule->context.push_back(literal);
    }
  }
}

std::vector<int> GoalPredicates(std::span<const Goal> goals) {
  std::set<int> predicates;
  for (const Goal& goal : goals) {
    for (const Literal& literal : goal.literals) {
      predicates.insert(literal.relation);
    }
  }
  return {predicates.begin(), predicates.end()};
}

rules::NdrRules LearnRules(std::span<const rules::Experience> experiences,
                           std::span<const int> goal_predicates,
                           const RuleWorld& world, int num_for_others) {
  const std::vector<Experience> all = WithReversed(experiences, world);
  std::vector<Experience> own;
  for (const Experience& e : all) own.push_back(OwnChanges(e, world));
  rules::Learner learner(world.world(), rules::LearnerOptions());
  for (const Experience& e : own) learner.Add(e);
  learner.Learn();
  rules::NdrRules rules = learner.Rules();
  std::vector<int> landmarks;
  for (const int predicate : goal_predicates) {
    landmarks.push_back(*world.world()->symbols().Find(
        world.vocabulary().predicates()[static_cast<size_t>(predicate)].name));
  }
  std::vector<int> counts = learner.RuleCounts();
  DropRare(&counts, &rules);
  MakeUnsure(counts, &rules);
  for (rules::Rule& rule : rules.rules) {
    Specialize(own, landmarks, *world.world(), &rule, num_for_others);
    AddEffectsOnOthers(all, landmarks, world, &rule);
  }
  return rules;
}

}  // namespace cell
