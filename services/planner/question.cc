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

/// "both arms", or the one arm.
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

/// "put the bolt_1 into hole_1"; without words of the domain "do Insert(bolt_1,
/// hole_1)".
std::string WordsFor(const GroundAction& action, const RuleSet& rules,
                     const RequestWords& requests) {
  const auto words = requests.ToDo(rules.ActionOf(action).name,
                                   action.arguments, rules.vocabulary());
  return words.value_or("do " + rules.Show(action));
}

/// "remove what is in hole_1"; without words of the domain "make
/// sure that Free(hole_1)".
std::string WordsFor(const RequiredChange& change, const Vocabulary& vocabulary,
                     const RequestWords& requests) {
  const bool is_true = change.truth == Truth::kTrue;
  const auto words =
      requests.ToMake(vocabulary.Atom(change.atom), is_true, vocabulary);
  return words.value_or(fmt::format("make sure that {}{}",
                                    is_true ? "" : "not ",
                                    vocabulary.AtomName(change.atom)));
}

/// Whether moving the object of the change does not make the change: what it
/// is by itself now, such as lying down, it is elsewhere too. What it is not,
/// or is to others, such as not clear, may be otherwise where it is moved to.
bool OutlastsMoving(const RequiredChange& change, const State& state,
                    const GroundAtom& atom) {
  return change.truth == Truth::kFalse && atom.objects.size() == 1 &&
         state.Get(change.atom) == Truth::kTrue;
}

/// Names only what a person has to fix. Of a part that has to be moved into
/// reach, most else cannot be judged before it is there.
ExecutionStatus AskForChanges(const Plan& no_plan, const State& state,
                              const Vocabulary& vocabulary,
                              const RequestWords& requests) {
  ExecutionStatus question{.state = ExecutionStatus::State::kStuck,
                           .needed = no_plan.needed};
  std::vector<std::string> sentences, formulas;
  std::set<int> out_of_reach;
  for (const RequiredChange& change : no_plan.needed) {
    if (!IsForReach(change, vocabulary)) continue;
    sentences.push_back(AskForReach(change, state, vocabulary));
    out_of_reach.insert(vocabulary.Atom(change.atom).objects[1]);
  }
  for (const RequiredChange& change : no_plan.needed) {
    const GroundAtom atom = vocabulary.Atom(change.atom);
    const bool is_told = std::ranges::any_of(atom.objects, [&](int object) {
      return out_of_reach.contains(object);
    });
    if (is_told && !OutlastsMoving(change, state, atom)) continue;
    sentences.push_back("please " + WordsFor(change, vocabulary, requests));
    formulas.push_back(change.why);
  }
  question.text = sentences.empty()
                      ? "no action leads to the goal from here: please take "
                        "apart what blocks it"
                      : fmt::format("{}", fmt::join(sentences, "; "));
  question.formula = sentences.empty()
                         ? no_plan.reason
                         : fmt::format("{}", fmt::join(formulas, "; "));
  return question;
}

ExecutionStatus AskAfterFailures(const GroundAction& action,
                                 const FailureHistory::Entry& failed,
                                 const RuleSet& rules,
                                 const RequestWords& requests) {
  const std::optional<GroundSkill> skill = rules.SkillOf(action);
  const std::string whose =
      skill ? "the " + rules.vocabulary().objects()[skill->arm].name + " arm"
            : "the robot";
  return {
      .state = ExecutionStatus::State::kStuck,
      .text = fmt::format("{} has tried {} times to {}, and failed: {}; please "
                          "do it yourself, or remove what prevents it",
                          whose, failed.count,
                          WordsFor(action, rules, requests), failed.reason),
      .formula = rules.Show(action),
      .step = action};
}

}  // namespace

ExecutionStatus AskForHelp(const CurrentPlan& plan, const State& state,
                           const FailureHistory& failures,
                           const RequestWords& requests) {
  if (!failures.Blocked().empty()) {
    const Plan unblocked = plan.FindUnblocked(state);
    const FailureHistory::Entry* failed =
        unblocked.steps.empty() ? nullptr
                                : failures.Of(unblocked.steps[0].action);
    if (failed != nullptr) {
      ExecutionStatus question = AskAfterFailures(
          unblocked.steps[0].action, *failed, plan.rules(), requests);
      question.needed = plan.get().needed;
      return question;
    }
  }
  return AskForChanges(plan.get(), state, plan.rules().vocabulary(), requests);
}

ExecutionStatus AskForDemonstration(const Plan& not_learned,
                                    const Vocabulary& vocabulary,
                                    const RequestWords& requests) {
  std::vector<std::string> words;
  for (const Literal& literal : not_learned.unlearned) {
    words.push_back(
        requests.ToMake(literal, vocabulary)
            .value_or("make sure that " + Show(literal, {}, vocabulary)));
  }
  return {.state = ExecutionStatus::State::kStuck,
          .text = fmt::format("please show me {}, which I have not learned "
                              "yet: {}",
                              words.size() == 1 ? "this" : "one of these",
                              fmt::join(words, "; ")),
          .formula = not_learned.reason,
          .unlearned = not_learned.unlearned};
}

std::string WordsForChanges(const Plan& no_plan, const Vocabulary& vocabulary,
                            const RequestWords& requests) {
  std::vector<std::string> words;
  for (const RequiredChange& change : no_plan.needed) {
    words.push_back(WordsFor(change, vocabulary, requests));
  }
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string AskForStep(const GroundAction& action, const RuleSet& rules,
                       const RequestWords& requests) {
  return "please " + WordsFor(action, rules, requests);
}

ExecutionStatus AskForConfirmation(const GroundAction& action,
                                   const RuleSet& rules) {
  const std::string& name = rules.ActionOf(action).name;
  return {.state = ExecutionStatus::State::kStuck,
          .text = fmt::format("{} was learned, and no arm has done it yet: let "
                              "me do {} at half speed (cell confirm {})",
                              name, rules.Show(action), name)};
}

std::string AskForView(const GroundAction& action, const RuleSet& rules,
                       const RequestWords& requests) {
  return "the sensors cannot tell whether it is possible to " +
         WordsFor(action, rules, requests) +
         ": please clear the view, or do it yourself";
}

}  // namespace cell::planner
