#include "services/planner/foresight.h"

#include <algorithm>

namespace cell::planner {

std::optional<State> LikelyAfter(const Domain& domain,
                                 const GroundAction& action,
                                 const State& state) {
  const Action& lifted = domain.actions()[action.action];
  const State known = state.UnknownAsFalse();
  const auto covers = CoversOf(lifted, action.arguments, known,
                               domain.vocabulary(), Agent::kRobot);
  if (covers.size() != 1) return std::nullopt;
  const auto& outcomes = lifted.rules[covers[0].rule].outcomes;
  const auto likeliest = std::max_element(
      outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) {
        return a.probability < b.probability;
      });
  if (likeliest == outcomes.end()) return std::nullopt;
  return After(*likeliest, covers[0].binding, known, domain.vocabulary());
}

bool IsSurelyPossible(const Domain& domain, const GroundAction& action,
                      const State& state) {
  const Action& lifted = domain.actions()[action.action];
  const Vocabulary& vocabulary = domain.vocabulary();
  const auto covers =
      CoversOf(lifted, action.arguments, state, vocabulary, Agent::kRobot);
  return std::any_of(covers.begin(), covers.end(), [&](const Cover& cover) {
    const auto& context = lifted.rules[cover.rule].context;
    return std::all_of(context.begin(), context.end(), [&](const Literal& l) {
      return MustHold(l, cover.binding, state, vocabulary);
    });
  });
}

bool DoNotDisturb(const Domain& domain, const GroundAction& a,
                  const GroundAction& b, const State& state) {
  const auto after_a = LikelyAfter(domain, a, state);
  const auto after_b = LikelyAfter(domain, b, state);
  return after_a && after_b && LikelyAfter(domain, b, *after_a) &&
         LikelyAfter(domain, a, *after_b);
}

}  // namespace cell::planner
