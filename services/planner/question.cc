#include "services/planner/question.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace cell::planner {
namespace {

constexpr auto kReachable = Predicate::Report::kReachable;

bool IsForReach(const RequiredChange& change, const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(change.atom);
  return vocabulary.predicates()[atom.predicate].report == kReachable &&
         change.truth == Truth::kTrue;
}

/// "of both arms", or of which one.
std::string OutOfWhoseReach(const GroundAtom& atom, const State& state,
                            const Vocabulary& vocabulary) {
  const auto& types = vocabulary.predicates()[atom.predicate].argument_types;
  const std::vector<int>& arms = vocabulary.ObjectsOf(types[0]);
  const bool is_in_none = std::all_of(arms.begin(), arms.end(), [&](int arm) {
    const std::vector<int> objects = {arm, atom.objects[1]};
    const auto other = vocabulary.AtomIndex(atom.predicate, objects);
    return !other || state.Get(*other) != Truth::kTrue;
  });
  if (is_in_none && arms.size() == 2) return "both arms";
  if (is_in_none && arms.size() > 2) return "all arms";
  return fmt::format("the {} arm", vocabulary.objects()[atom.objects[0]].name);
}

std::string AskForReach(const RequiredChange& change, const State& state,
                        const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(change.atom);
  return fmt::format("{} is out of reach of {}: please move it into reach",
                     vocabulary.objects()[atom.objects[1]].name,
                     OutOfWhoseReach(atom, state, vocabulary));
}

/// Names what a person has to see to, and nothing else. What is to be moved
/// into reach cannot be judged otherwise before it is.
std::string AskForChanges(const Plan& no_plan, const State& state,
                          const Vocabulary& vocabulary) {
  std::vector<std::string> sentences;
  std::set<int> out_of_reach;
  for (const RequiredChange& change : no_plan.needed) {
    if (!IsForReach(change, vocabulary)) continue;
    sentences.push_back(AskForReach(change, state, vocabulary));
    out_of_reach.insert(vocabulary.Atom(change.atom).objects[1]);
  }
  for (const RequiredChange& change : no_plan.needed) {
    const std::vector<int> objects = vocabulary.Atom(change.atom).objects;
    const bool is_told = std::ranges::any_of(
        objects, [&](int object) { return out_of_reach.contains(object); });
    if (!is_told) sentences.push_back(change.why);
  }
  return sentences.empty() ? no_plan.reason
                           : fmt::format("{}", fmt::join(sentences, "; "));
}

std::string AskAfterFailures(const GroundAction& action,
                             const FailureHistory::Entry& failed,
                             const RuleSet& rules) {
  const std::optional<GroundSkill> skill = rules.SkillOf(action);
  const std::string by_arm =
      skill
          ? " by the " + rules.vocabulary().objects()[skill->arm].name + " arm"
          : "";
  return fmt::format(
      "{}{} has failed {} times: {}; please do it, or change what hinders it",
      rules.Show(action), by_arm, failed.count, failed.reason);
}

}  // namespace

std::string AskForHelp(const CurrentPlan& plan, const State& state,
                       const FailureHistory& failures) {
  if (!failures.Blocked().empty()) {
    const Plan unblocked = plan.FindUnblocked(state);
    const FailureHistory::Entry* failed =
        unblocked.steps.empty() ? nullptr
                                : failures.Of(unblocked.steps[0].action);
    if (failed != nullptr) {
      return AskAfterFailures(unblocked.steps[0].action, *failed, plan.rules());
    }
  }
  return AskForChanges(plan.get(), state, plan.rules().vocabulary());
}

std::string AskForStep(const GroundAction& action, const RuleSet& rules) {
  return "please do " + rules.Show(action);
}

}  // namespace cell::planner
