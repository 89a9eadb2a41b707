#include "services/planner/rule_alternatives.h"

#include <algorithm>
#include <set>
#include <utility>

#include "common/relational/ground_action.h"
#include "common/relational/literal_properties.h"

namespace cell::planner {
namespace {

/// Places in the rule's context of the conditions that fail, without those on
/// what arms report.
std::vector<size_t> FailingConditions(const NdrRule& rule,
                                      const Binding& binding,
                                      const State& state,
                                      const Vocabulary& vocabulary) {
  std::vector<size_t> failing;
  for (size_t i = 0; i < rule.context.size(); ++i) {
    const Literal& literal = rule.context[i];
    if (!IsReported(literal, vocabulary) &&
        !MustHold(literal, binding, state, vocabulary)) {
      failing.push_back(i);
    }
  }
  return failing;
}

/// What follows of the action's arguments from conditions that are dropped: of
/// "nothing is in anything" that it is in nothing, and that nothing is in its
/// hole.
std::vector<Literal> ConsequencesFor(const std::vector<Literal>& dropped,
                                     const Action& action,
                                     const Vocabulary& vocabulary) {
  std::vector<Literal> consequences;
  for (const Literal& literal : dropped) {
    if (!literal.is_negated || literal.is_static) continue;
    const auto& types =
        vocabulary.predicates()[static_cast<size_t>(literal.relation)]
            .argument_types;
    for (size_t i = 0; i < literal.terms.size(); ++i) {
      if (literal.terms[i].kind != Term::Kind::kAny) continue;
      for (size_t a = 0; a < action.arguments.size(); ++a) {
        if (!vocabulary.types().IsA(action.arguments[a].type, types[i])) {
          continue;
        }
        consequences.push_back(literal);
        consequences.back().terms[i] = {Term::Kind::kVariable,
                                        static_cast<int>(a)};
      }
    }
  }
  return consequences;
}

/// The action when all of its learned rules with these conditions lack them:
/// there is one for each way an arm can begin.
Action Without(Action action, const std::vector<Literal>& dropped,
               const Vocabulary& vocabulary) {
  const auto consequences = ConsequencesFor(dropped, action, vocabulary);
  for (NdrRule& rule : action.rules) {
    const bool has_all = std::ranges::all_of(dropped, [&](const Literal& d) {
      return std::ranges::count(rule.context, d) > 0;
    });
    if (rule.num_experiences == 0 || !has_all) continue;
    std::erase_if(rule.context, [&](const Literal& literal) {
      return std::ranges::count(dropped, literal) > 0;
    });
    for (const Literal& literal : consequences) {
      if (std::ranges::count(rule.context, literal) > 0) continue;
      rule.context.push_back(literal);
    }
  }
  return action;
}

/// True if nothing has become different of the action's objects.
bool HasChangedNothing(const TaskExperience& experience,
                       const Vocabulary& vocabulary) {
  for (int i = 0; i < experience.before.num_atoms(); ++i) {
    const Truth before = experience.before.Get(i);
    const Truth after = experience.after.Get(i);
    if (before == after || before == Truth::kUnknown ||
        after == Truth::kUnknown) {
      continue;
    }
    const bool is_own =
        std::ranges::any_of(vocabulary.Atom(i).objects, [&](int object) {
          return std::ranges::count(experience.objects, object) > 0;
        });
    if (is_own) return false;
  }
  return true;
}

/// Experiences in which the action changed nothing although a person could have
/// done it by its rules.
int NumFailures(const Action& action,
                std::span<const TaskExperience> experiences,
                const Vocabulary& vocabulary) {
  return static_cast<int>(
      std::ranges::count_if(experiences, [&](const TaskExperience& e) {
        return e.action == action.name &&
               e.objects.size() == action.arguments.size() &&
               HasChangedNothing(e, vocabulary) &&
               !ApplicableRules(action, e.objects, e.before.UnknownAsFalse(),
                                vocabulary, Agent::kPerson)
                    .empty();
      }));
}

struct Dropped {
  int action;
  std::vector<Literal> literals;
};

/// What would have to be dropped so that some learned rule covers the state.
std::vector<Dropped> DroppableIn(const RuleSet& rules, const State& state) {
  std::vector<Dropped> found;
  for (const GroundAction& ground : rules.GroundActions(Agent::kRobot)) {
    for (const NdrRule& rule : rules.ActionOf(ground).rules) {
      if (!rule.IsFor(Agent::kRobot) || rule.num_experiences == 0 ||
          !rule.references.empty()) {
        continue;
      }
      Dropped dropped{ground.action, {}};
      for (const size_t i : FailingConditions(rule, ground.arguments, state,
                                              rules.vocabulary())) {
        dropped.literals.push_back(rule.context[i]);
      }
      const bool is_known =
          std::ranges::any_of(found, [&](const Dropped& other) {
            return other.action == dropped.action &&
                   other.literals == dropped.literals;
          });
      if (dropped.literals.empty() || is_known ||
          std::ranges::any_of(dropped.literals, NamesVariable)) {
        continue;
      }
      found.push_back(std::move(dropped));
    }
  }
  std::ranges::stable_sort(found, {},
                           [](const Dropped& d) { return d.literals.size(); });
  return found;
}

}  // namespace

std::vector<RuleAlternative> AlternativesIn(
    const RuleSet& rules, const State& state,
    std::span<const TaskExperience> experiences, int max_failures) {
  std::vector<RuleAlternative> alternatives;
  for (const Dropped& dropped : DroppableIn(rules, state)) {
    std::vector<Action> actions = rules.actions();
    Action& action = actions[static_cast<size_t>(dropped.action)];
    action = Without(action, dropped.literals, rules.vocabulary());
    if (NumFailures(action, experiences, rules.vocabulary()) >= max_failures) {
      continue;
    }
    alternatives.push_back(
        {std::make_shared<const RuleSet>(rules.source(), rules.version(),
                                         rules.shared_vocabulary(),
                                         std::move(actions)),
         dropped.action, static_cast<int>(dropped.literals.size())});
  }
  return alternatives;
}

}  // namespace cell::planner
