#include "services/planner/excuse.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace cell::planner {
namespace {

/// Atoms that have the same truth in all of the states.
std::vector<int> ConstantAtoms(const StateSpace& space,
                               const std::vector<int>& states) {
  std::vector<int> constant;
  const State& first = space.state(states.front());
  for (int atom = 0; atom < first.num_atoms(); ++atom) {
    const bool is_constant = std::all_of(
        states.begin(), states.end(),
        [&](int s) { return space.state(s).Get(atom) == first.Get(atom); });
    if (is_constant) constant.push_back(atom);
  }
  return constant;
}

/// True if a rule of the action has the atom in its context with this truth.
/// Literals over deictic variables are left out: their objects are not known.
bool Needs(const StateSpace& space, const GroundAction& action, int atom,
           Truth truth) {
  const Vocabulary& vocabulary = space.rules().vocabulary();
  const Action& lifted = space.rules().ActionOf(action);
  const int num_arguments = static_cast<int>(action.arguments.size());
  for (const NdrRule& rule : lifted.rules) {
    if (!rule.IsFor(space.agent())) continue;
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

/// Constant atoms that keep some action from being possible. Those of the
/// goal's predicates only if asked for, and only what is true: assuming the
/// goal would explain nothing, but what was done may have to be undone.
std::vector<int> Obstacles(const StateSpace& space, int state, const Goal& goal,
                           bool with_undoing) {
  const Vocabulary& vocabulary = space.rules().vocabulary();
  std::set<int> goal_predicates;
  for (const Literal& l : goal.literals) goal_predicates.insert(l.relation);
  std::vector<int> obstacles;
  for (const int atom : ConstantAtoms(space, space.ReachableFrom(state))) {
    const Truth wanted = Opposite(space.state(state).Get(atom));
    if (goal_predicates.contains(vocabulary.Atom(atom).predicate) &&
        !(with_undoing && wanted == Truth::kFalse)) {
      continue;
    }
    const Predicate& predicate =
        vocabulary.predicates()[vocabulary.Atom(atom).predicate];
    if (predicate.report == Predicate::Report::kHeld &&
        wanted == Truth::kTrue) {
      continue;
    }
    const bool is_needed =
        std::any_of(space.actions().begin(), space.actions().end(),
                    [&](const GroundAction& action) {
                      return Needs(space, action, atom, wanted);
                    });
    if (is_needed) obstacles.push_back(atom);
  }
  return obstacles;
}

using HasPlan = std::function<bool(const std::vector<int>& flipped)>;

/// The atoms of each object, of the object with the fewest first.
std::vector<std::vector<int>> ByObject(const std::vector<int>& atoms,
                                       const Vocabulary& vocabulary) {
  std::map<int, std::vector<int>> atoms_of;
  for (const int atom : atoms) {
    const std::vector<int>& objects = vocabulary.Atom(atom).objects;
    for (const int object : std::set(objects.begin(), objects.end())) {
      atoms_of[object].push_back(atom);
    }
  }
  std::vector<std::vector<int>> groups;
  for (auto& [object, group] : atoms_of) groups.push_back(std::move(group));
  std::ranges::stable_sort(groups, {}, &std::vector<int>::size);
  return groups;
}

/// Leaves out of `atoms`, which allow a plan, what is not needed.
std::vector<int> Minimal(std::vector<int> atoms, const HasPlan& has_plan) {
  // What is flipped may need others flipped only because of itself: again until
  // nothing can be left out.
  for (size_t num_before = 0; num_before != atoms.size();) {
    num_before = atoms.size();
    for (size_t i = 0; i < atoms.size();) {
      std::vector<int> fewer = atoms;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (has_plan(fewer)) {
        atoms = std::move(fewer);
      } else {
        ++i;
      }
    }
  }
  return atoms;
}

/// A minimal subset of `atoms` that allows a plan when flipped: one atom, or
/// else some of one object, or else of all of them; empty if there is none of
/// these. To flip all at once may itself be what prevents a plan.
std::vector<int> LeastExcuse(const std::vector<int>& atoms,
                             const Vocabulary& vocabulary,
                             const HasPlan& has_plan) {
  for (const int atom : atoms) {
    if (has_plan({atom})) return {atom};
  }
  for (const std::vector<int>& group : ByObject(atoms, vocabulary)) {
    if (group.size() > 1 && has_plan(group)) return Minimal(group, has_plan);
  }
  if (!has_plan(atoms)) return {};
  return Minimal(atoms, has_plan);
}

/// The goal's literals that fail in the reachable state where fewest do.
std::string MissingLiterals(const StateSpace& space, int state,
                            const Goal& goal) {
  const Vocabulary& vocabulary = space.rules().vocabulary();
  std::vector<std::string> fewest;
  for (const int s : space.ReachableFrom(state)) {
    std::vector<std::string> missing;
    for (const Literal& literal : goal.literals) {
      if (MayHold(literal, {}, space.state(s), vocabulary)) continue;
      missing.push_back(Show(literal, {}, vocabulary));
    }
    if (fewest.empty() || missing.size() < fewest.size()) fewest = missing;
  }
  std::string text;
  for (size_t i = 0; i < fewest.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < fewest.size() ? ", " : " and ") + fewest[i];
  }
  return text;
}

/// The first of the steps that needs the opposite of the atom.
std::optional<GroundAction> StepThatNeeds(const StateSpace& space,
                                          const State& state, int atom,
                                          const std::vector<PlanStep>& steps) {
  const auto step =
      std::find_if(steps.begin(), steps.end(), [&](const PlanStep& s) {
        return Needs(space, s.action, atom, Opposite(state.Get(atom)));
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

Excuse ExplainNoPlan(const StateSpace& space, int state, const Goal& goal,
                     const std::function<Plan(const State&)>& solve) {
  const State& here = space.state(state);
  Excuse because{"cannot be reached: " + MissingLiterals(space, state, goal),
                 {}};
  const auto has_plan = [&](const std::vector<int>& flipped) {
    return solve(Flipped(here, flipped)).leads_to_goal();
  };
  std::vector<int> excuse;
  for (const bool with_undoing : {false, true}) {
    if (!excuse.empty()) break;
    excuse = LeastExcuse(Obstacles(space, state, goal, with_undoing),
                         space.rules().vocabulary(), has_plan);
  }
  if (excuse.empty()) {
    because.text += "; no action leads there";
    return because;
  }
  const std::vector<PlanStep> steps = solve(Flipped(here, excuse)).steps;
  for (const int atom : excuse) {
    const auto needed_by = StepThatNeeds(space, here, atom, steps);
    const std::string why = Complaint(space.rules(), here, atom, needed_by);
    because.text += "; " + why;
    because.needed.push_back({atom, Opposite(here.Get(atom)), why, needed_by});
  }
  return because;
}

}  // namespace cell::planner
