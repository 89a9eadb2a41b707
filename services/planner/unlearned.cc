#include "services/planner/unlearned.h"

#include <algorithm>
#include <span>

#include "common/relational/literal_properties.h"

namespace cell::planner {
namespace {

/// An action's arguments, then a rule's references, then `each` of an effect.
std::vector<Variable> VariablesOf(const Action& action, const NdrRule& rule,
                                  std::span<const Variable> each = {}) {
  std::vector<Variable> variables = action.arguments;
  for (const DeicticReference& reference : rule.references) {
    variables.push_back(reference.variable);
  }
  variables.insert(variables.end(), each.begin(), each.end());
  return variables;
}

bool BringsAbout(const Action& action, const NdrRule& rule,
                 const Literal& literal, const Vocabulary& vocabulary) {
  return std::ranges::any_of(rule.outcomes, [&](const Outcome& outcome) {
    return outcome.probability > 0 &&
           std::ranges::any_of(outcome.effects, [&](const Effect& effect) {
             const auto variables = VariablesOf(action, rule, effect.each);
             return std::ranges::any_of(effect.then, [&](const Literal& then) {
               return MayBe(then, variables, literal, vocabulary);
             });
           });
  });
}

struct RuleOfAction {
  const Action* action;
  const NdrRule* rule;
};

std::vector<RuleOfAction> RulesThatBringAbout(const Literal& literal,
                                              const Problem& problem) {
  std::vector<RuleOfAction> found;
  for (const Action& action : problem.rules->actions()) {
    for (const NdrRule& rule : action.rules) {
      if (rule.IsFor(problem.agent) &&
          BringsAbout(action, rule, literal, problem.rules->vocabulary())) {
        found.push_back({&action, &rule});
      }
    }
  }
  return found;
}

/// True if the rule cannot do without a literal that does not hold yet.
bool Needs(const RuleOfAction& of, std::span<const Literal> literals,
           const Vocabulary& vocabulary) {
  const auto variables = VariablesOf(*of.action, *of.rule);
  return std::ranges::any_of(of.rule->context, [&](const Literal& needed) {
    return std::ranges::any_of(literals, [&](const Literal& literal) {
      return MayBe(needed, variables, literal, vocabulary);
    });
  });
}

bool IsOpen(const Literal& literal, const State& state,
            const Vocabulary& vocabulary) {
  return !MayHold(literal, {}, state, vocabulary);
}

}  // namespace

std::vector<Literal> UnlearnedLiterals(const Problem& problem,
                                       const State& state) {
  std::vector<Literal> unlearned;
  for (const Literal& literal : problem.goal.literals) {
    if (IsOpen(literal, state, problem.rules->vocabulary()) &&
        RulesThatBringAbout(literal, problem).empty()) {
      unlearned.push_back(literal);
    }
  }
  return unlearned;
}

Goal Subgoals(const Problem& problem, const State& state,
              const std::vector<Literal>& unlearned) {
  const Vocabulary& vocabulary = problem.rules->vocabulary();
  std::vector<Literal> left_out = unlearned;
  const auto depends = [&](const Literal& literal) {
    return IsOpen(literal, state, vocabulary) &&
           std::ranges::all_of(RulesThatBringAbout(literal, problem),
                               [&](const RuleOfAction& of) {
                                 return Needs(of, left_out, vocabulary);
                               });
  };
  Goal subgoals = problem.goal;
  for (size_t before = 0; before != subgoals.literals.size();) {
    before = subgoals.literals.size();
    std::erase_if(subgoals.literals, [&](const Literal& literal) {
      const bool is_left_out =
          std::ranges::count(left_out, literal) > 0 || depends(literal);
      if (is_left_out) left_out.push_back(literal);
      return is_left_out;
    });
  }
  return subgoals;
}

}  // namespace cell::planner
