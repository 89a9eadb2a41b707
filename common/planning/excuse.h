#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// A literal that would have to hold at first.
struct RequiredChange {
  Literal literal;
  std::vector<std::string> needed_by;  ///< actions, at most three
  bool has_producer = false;  ///< an action could bring it about elsewhere
  bool is_of_goal = false;    ///< the goal asks for it
  bool operator==(const RequiredChange&) const = default;
};

/// A smallest change of the initial state that makes the goal reachable
/// (Goebelbecker et al., ICAPS 2010; the paper's section VI-B1).
struct Excuse {
  std::vector<RequiredChange> changes;  ///< ascending literals
  /// What can be done before the excuse is cleared up, each by itself: the
  /// goal's literals that do not depend on it, and for the others what else
  /// the actions need that would bring them about.
  std::vector<Literal> subgoals;
  bool operator==(const Excuse&) const = default;
};

struct ExcuseOptions {
  int max_changes = 6;
  int max_excuses = 8;
  /// Sets of changes that are tried at most.
  int64_t max_trials = 50'000;
  /// States that are expanded at most for each of them.
  int64_t max_expansions = 20'000;
  /// Changes that may be asked for; if empty, all.
  std::function<bool(const Literal&)> may_change = {};
};

struct Excuses {
  bool is_solvable = false;     ///< as it is: no excuse is needed
  std::vector<Excuse> excuses;  ///< all equally small, best first
  /// True if no smaller change of allowed literals helps; false if the search
  /// was cut short by an option.
  bool is_minimal = false;
  int64_t num_trials = 0;
  bool operator==(const Excuses&) const = default;
};

/// Candidates come from regression: from the goal back over the actions to
/// what cannot be reached even if nothing is ever undone. Every excuse holds at
/// least one of these literals, and at least as many as there are parts of the
/// goal that have none of them in common. Among equally small excuses those
/// come first that assume the fewest literals of the goal, since assuming the
/// goal explains little; then for the fewest facts of a kind that is given
/// with the task (some hold, no action makes any true), since rules are more
/// likely to be wrong than facts; then for the fewest literals that an action
/// brings about. One of each combination of predicates comes before the second
/// of any.
/// @param task  with its constant atoms, see ConstantAtoms::kKeep
Excuses FindExcuses(const GroundTask& task, const ExcuseOptions& options = {});

/// How a predicate is said: "{0} is on {1}", "{0} is not on {1}".
struct PredicateWords {
  std::string when_true;
  std::string when_false;
};
/// By the predicate's name; others are said as "on(a, b)", "not on(a, b)".
using Words = std::map<std::string, PredicateWords>;

/// "b is free"
std::string Say(const Literal& literal, const GroundTask& task,
                const Words& words = {});

/// "pick-up(b, c) needs: b is free; but b is not free, and no action changes
/// that"
std::string Explain(const Excuse& excuse, const GroundTask& task,
                    const Words& words = {});

}  // namespace cell::planning
