#include "services/planner/outcome_prediction.h"

#include <algorithm>

namespace cell::planner {

std::optional<State> MostLikelyOutcome(const RuleSet& rules,
                                       const GroundAction& action,
                                       const State& state, Agent agent) {
  const Action& lifted = rules.ActionOf(action);
  const State known = state.UnknownAsFalse();
  const auto applicable = ApplicableRules(lifted, action.arguments, known,
                                          rules.vocabulary(), agent);
  if (applicable.size() != 1) return std::nullopt;
  const auto& outcomes = lifted.rules[applicable[0].rule].outcomes;
  const auto likeliest = std::max_element(
      outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) {
        return a.probability < b.probability;
      });
  if (likeliest == outcomes.end()) return std::nullopt;
  return Apply(*likeliest, applicable[0].binding, known, rules.vocabulary());
}

bool IsSurelyPossible(const RuleSet& rules, const GroundAction& action,
                      const State& state) {
  const Action& lifted = rules.ActionOf(action);
  const Vocabulary& vocabulary = rules.vocabulary();
  const auto applicable = ApplicableRules(lifted, action.arguments, state,
                                          vocabulary, Agent::kRobot);
  return std::any_of(
      applicable.begin(), applicable.end(), [&](const ApplicableRule& a) {
        const auto& context = lifted.rules[a.rule].context;
        return std::all_of(context.begin(), context.end(),
                           [&](const Literal& l) {
                             return MustHold(l, a.binding, state, vocabulary);
                           });
      });
}

bool AreIndependent(const RuleSet& rules, const GroundAction& a,
                    const GroundAction& b, const State& state) {
  const auto after_a = MostLikelyOutcome(rules, a, state);
  const auto after_b = MostLikelyOutcome(rules, b, state);
  return after_a && after_b && MostLikelyOutcome(rules, b, *after_a) &&
         MostLikelyOutcome(rules, a, *after_b);
}

}  // namespace cell::planner
