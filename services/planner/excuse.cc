#include "services/planner/excuse.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/planning/excuse.h"
#include "common/planning/ground_rules.h"

namespace cell::planner {
namespace {

/// Sets of changes that are tried at most: a question must not take long.
constexpr int64_t kMaxTrials = 300;
/// Equally small ones that are compared by their plans.
constexpr int kMaxExcuses = 8;
constexpr double kSameProbability = 1e-6;
/// Of more changes a person would not be asked at once.
constexpr int kMaxChanges = 24;

/// Of each atom, if it has the same truth in all of the states.
std::vector<bool> ConstantAtoms(const StateSpace& space,
                                const std::vector<int>& states) {
  const State& first = space.state(states.front());
  std::vector<bool> is_constant(static_cast<size_t>(first.num_atoms()), true);
  for (const int s : states) {
    for (size_t atom = 0; atom < is_constant.size(); ++atom) {
      const int i = static_cast<int>(atom);
      if (space.state(s).Get(i) != first.Get(i)) is_constant[atom] = false;
    }
  }
  return is_constant;
}

/// True if a rule of the action has the atom in its context with this truth.
/// Literals over deictic variables are left out: their objects are not known.
bool Needs(const RuleSet& rules, Agent agent, const GroundAction& action,
           int atom, Truth truth) {
  const Vocabulary& vocabulary = rules.vocabulary();
  const Action& lifted = rules.ActionOf(action);
  const int num_arguments = static_cast<int>(action.arguments.size());
  for (const NdrRule& rule : lifted.rules) {
    if (!rule.IsFor(agent)) continue;
    for (const Literal& literal : rule.context) {
      const bool is_bound = std::all_of(
          literal.terms.begin(), literal.terms.end(), [&](const Term& term) {
            return term.kind != Term::Kind::kVariable ||
                   term.index < num_arguments;
          });
      if (literal.is_static || !is_bound) continue;
      if (literal.is_negated != (truth == Truth::kFalse)) continue;
      const auto atoms = Groundings(literal, action.arguments, vocabulary);
      if (std::count(atoms.begin(), atoms.end(), atom) > 0) return true;
    }
  }
  return false;
}

Truth Opposite(Truth truth) {
  return truth == Truth::kTrue ? Truth::kFalse : Truth::kTrue;
}

State Flipped(State state, const std::vector<int>& atoms) {
  for (const int atom : atoms) state.Set(atom, Opposite(state.Get(atom)));
  return state;
}

/// Which changes a person may be asked for. Those of the goal's predicates only
/// if asked for, and only what is true: assuming the goal would explain
/// nothing, but what was done may have to be undone.
bool MayAskFor(const planning::Literal& change, const Problem& problem,
               bool with_undoing) {
  const Vocabulary& vocabulary = problem.rules->vocabulary();
  const int predicate = vocabulary.Atom(change.atom).predicate;
  const bool is_of_goal =
      std::ranges::any_of(problem.goal.literals, [&](const Literal& literal) {
        return !literal.is_static && literal.relation == predicate;
      });
  if (is_of_goal && !(with_undoing && !change.value)) return false;
  const auto report =
      vocabulary.predicates()[static_cast<size_t>(predicate)].report;
  return report != Predicate::Report::kHeld || !change.value;
}

/// The problem from a state, without its blocked actions.
planning::GroundTask TaskFrom(const Problem& problem, const State& state) {
  planning::RuleTask rules =
      planning::GroundRules(*problem.rules, problem.goal, problem.agent, state);
  std::vector<planning::GroundAction> actions;
  for (size_t i = 0; i < rules.action_of.size(); ++i) {
    if (problem.blocked.contains(rules.action_of[i])) continue;
    actions.push_back(std::move(rules.task.actions[i]));
  }
  rules.task.actions = std::move(actions);
  return std::move(rules.task);
}

/// The atoms of each of the best excuses, which are equally small.
std::vector<std::vector<int>> SmallestExcuses(
    const planning::GroundTask& task, const std::vector<bool>& is_constant,
    const Problem& problem, bool with_undoing) {
  planning::ExcuseOptions options{.max_changes = kMaxChanges,
                                  .max_excuses = kMaxExcuses,
                                  .max_trials = kMaxTrials};
  options.may_change = [&](const planning::Literal& change) {
    return is_constant[static_cast<size_t>(change.atom)] &&
           MayAskFor(change, problem, with_undoing);
  };
  std::vector<std::vector<int>> excuses;
  for (const auto& excuse : planning::FindExcuses(task, options).excuses) {
    std::vector<int>& atoms = excuses.emplace_back();
    for (const auto& change : excuse.changes) {
      atoms.push_back(change.literal.atom);
    }
  }
  return excuses;
}

/// The changes that are asked for, and the plan after them.
struct Remedy {
  std::vector<int> atoms;
  Plan plan;
};

/// Of equally small excuses the one with the best plan, the first of several:
/// it says what the next steps need, not what a way round needs.
Remedy BestRemedy(const std::vector<std::vector<int>>& excuses,
                  const State& here,
                  const std::function<Plan(const State&)>& solve) {
  const auto is_better = [](const Plan& a, const Plan& b) {
    if (std::abs(a.probability - b.probability) > kSameProbability) {
      return a.probability > b.probability;
    }
    return a.expected_actions < b.expected_actions;
  };
  Remedy best;
  for (const std::vector<int>& atoms : excuses) {
    Plan plan = solve(Flipped(here, atoms));
    if (best.atoms.empty() || is_better(plan, best.plan)) {
      best = {atoms, std::move(plan)};
    }
  }
  return best;
}

/// The goal's literals that fail in the one of the states where fewest do.
std::string MissingLiterals(const StateSpace& space,
                            const std::vector<int>& states, const Goal& goal) {
  const Vocabulary& vocabulary = space.rules().vocabulary();
  std::vector<Literal> fewest;
  for (const int s : states) {
    std::vector<Literal> missing;
    for (const Literal& literal : goal.literals) {
      if (MayHold(literal, {}, space.state(s), vocabulary)) continue;
      missing.push_back(literal);
    }
    if (fewest.empty() || missing.size() < fewest.size()) {
      fewest = std::move(missing);
    }
  }
  std::string text;
  for (size_t i = 0; i < fewest.size(); ++i) {
    text += i == 0 ? "" : i + 1 < fewest.size() ? ", " : " and ";
    text += Show(fewest[i], {}, vocabulary);
  }
  return text;
}

/// The first of the steps that needs the opposite of the atom.
std::optional<GroundAction> StepThatNeeds(const RuleSet& rules, Agent agent,
                                          const State& state, int atom,
                                          const std::vector<PlanStep>& steps) {
  const auto step =
      std::find_if(steps.begin(), steps.end(), [&](const PlanStep& s) {
        return Needs(rules, agent, s.action, atom, Opposite(state.Get(atom)));
      });
  if (step == steps.end()) return std::nullopt;
  return step->action;
}

/// "Insert(a, b) needs Clear(a), but Clear(a) is false and no action makes it
/// true"
std::string Complaint(const RuleSet& rules, const State& state, int atom,
                      const std::optional<GroundAction>& needed_by) {
  const bool is_true = state.Get(atom) == Truth::kTrue;
  const std::string name = rules.vocabulary().AtomName(atom);
  std::string text;
  if (needed_by) text = rules.Show(*needed_by) + " needs ";
  text += (is_true ? "not " : "") + name + ", but " + name;
  return text + (is_true ? " is true and no action makes it false"
                         : " is false and no action makes it true");
}

}  // namespace

Excuse ExplainNoPlan(const Problem& problem, const StateSpace& space, int state,
                     const std::function<Plan(const State&)>& solve) {
  const std::vector<int> states = space.ReachableFrom(state);
  const State here = space.state(state);
  Excuse because{
      "cannot be reached: " + MissingLiterals(space, states, problem.goal), {}};
  const std::vector<bool> is_constant = ConstantAtoms(space, states);
  const planning::GroundTask task = TaskFrom(problem, here);
  auto excuses = SmallestExcuses(task, is_constant, problem, false);
  if (excuses.empty()) {
    excuses = SmallestExcuses(task, is_constant, problem, true);
  }
  if (excuses.empty()) {
    because.text += "; no action leads there";
    return because;
  }
  // The space may be filled anew.
  const Remedy remedy = BestRemedy(excuses, here, solve);
  for (const int atom : remedy.atoms) {
    const auto needed_by = StepThatNeeds(*problem.rules, problem.agent, here,
                                         atom, remedy.plan.steps);
    const std::string why = Complaint(*problem.rules, here, atom, needed_by);
    because.text += "; " + why;
    because.needed.push_back({atom, Opposite(here.Get(atom)), why, needed_by});
  }
  return because;
}

}  // namespace cell::planner
