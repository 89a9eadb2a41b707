#include "services/planner/question.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace cell::planner {
namespace {

constexpr auto kReachable = Predicate::Report::kReachable;

bool IsForReach(const Wish& wish, const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(wish.atom);
  return vocabulary.predicates()[atom.predicate].report == kReachable &&
         wish.truth == Truth::kTrue;
}

/// "of both arms", or of which one.
std::string OutOfWhoseReach(const GroundAtom& wished, const State& state,
                            const Vocabulary& vocabulary) {
  const auto& types = vocabulary.predicates()[wished.predicate].argument_types;
  const std::vector<int>& arms = vocabulary.ObjectsOf(types[0]);
  const bool is_in_none = std::all_of(arms.begin(), arms.end(), [&](int arm) {
    const std::vector<int> objects = {arm, wished.objects[1]};
    const auto atom = vocabulary.AtomIndex(wished.predicate, objects);
    return !atom || state.Get(*atom) != Truth::kTrue;
  });
  if (is_in_none && arms.size() == 2) return "both arms";
  if (is_in_none && arms.size() > 2) return "all arms";
  return fmt::format("the {} arm",
                     vocabulary.objects()[wished.objects[0]].name);
}

std::string AskForReach(const Wish& wish, const State& state,
                        const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(wish.atom);
  return fmt::format("{} is out of reach of {}: please move it into reach",
                     vocabulary.objects()[atom.objects[1]].name,
                     OutOfWhoseReach(atom, state, vocabulary));
}

/// Names what a person has to see to, and nothing else. What is to be moved
/// into reach cannot be judged otherwise before it is.
std::string AskForWishes(const Plan& no_plan, const State& state,
                         const Domain& domain) {
  const Vocabulary& vocabulary = domain.vocabulary();
  std::vector<std::string> sentences;
  std::set<int> out_of_reach;
  for (const Wish& wish : no_plan.needed) {
    if (!IsForReach(wish, vocabulary)) continue;
    sentences.push_back(AskForReach(wish, state, vocabulary));
    out_of_reach.insert(vocabulary.Atom(wish.atom).objects[1]);
  }
  for (const Wish& wish : no_plan.needed) {
    const std::vector<int> objects = vocabulary.Atom(wish.atom).objects;
    const bool is_told = std::ranges::any_of(
        objects, [&](int object) { return out_of_reach.contains(object); });
    if (!is_told) sentences.push_back(wish.why);
  }
  return sentences.empty() ? no_plan.reason
                           : fmt::format("{}", fmt::join(sentences, "; "));
}

std::string AskAfterFailures(const GroundAction& action,
                             const Attempts::Entry& attempts,
                             const Domain& domain) {
  // Only what arms do is tried.
  const std::string& arm =
      domain.vocabulary().objects()[domain.SkillOf(action)->arm].name;
  return fmt::format(
      "{} by the {} arm has failed {} times: {}; please do it, or change what "
      "hinders it",
      domain.Show(action), arm, attempts.count, attempts.reason);
}

}  // namespace

std::string AskForHelp(const Plan& no_plan, const State& state,
                       PlanSearch unblocked, const Attempts& attempts) {
  const Domain& domain = unblocked.domain();
  if (!attempts.Blocked().empty()) {
    const Plan plan = unblocked.Find(state);
    const Attempts::Entry* failed =
        plan.steps.empty() ? nullptr : attempts.Of(plan.steps[0].action);
    if (failed != nullptr) {
      return AskAfterFailures(plan.steps[0].action, *failed, domain);
    }
  }
  return AskForWishes(no_plan, state, domain);
}

std::string AskForStep(const GroundAction& action, const Domain& domain) {
  return "please do " + domain.Show(action);
}

}  // namespace cell::planner
