#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// A smallest change of the initial state that makes the goal reachable
/// (Goebelbecker et al., ICAPS 2010; the paper's section VI-B1).
struct Excuse {
  std::vector<Literal> changes;  ///< in ascending order
  /// Of each change the actions that need it, at most three, by name.
  std::vector<std::vector<std::string>> needed_by;
  /// Literals that stand for the goal until the excuse is cleared up: those of
  /// the goal that do not depend on it, and for the others what else the
  /// actions need that would bring them about.
  std::vector<Literal> subgoals;
  bool operator==(const Excuse&) const = default;
};

struct ExcuseOptions {
  int max_changes = 3;
  int max_excuses = 8;
  /// Of the planner, for each change that is tried.
  int64_t max_expansions = 20'000;
  /// Changes that are tried at most.
  int64_t max_trials = 20'000;
  /// Changes that may be asked for; if empty, all. Literals of the goal are
  /// used only if no others help, since to wish for the goal explains nothing.
  std::function<bool(const Literal&)> may_change;
};

struct Excuses {
  bool is_solvable = false;     ///< as it is: no excuse is needed
  std::vector<Excuse> excuses;  ///< all equally small, best first
  /// True if it is proven that no smaller change of allowed literals helps.
  bool is_minimal = false;
  int64_t num_trials = 0;
  bool operator==(const Excuses&) const = default;
};

/// Candidates come from regression: from the goal back over the actions to
/// what cannot be reached even if nothing is ever deleted. One of these
/// literals at least is part of every excuse. Among equally small ones those
/// come first that no action could bring about.
Excuses FindExcuses(const GroundTask& task, const ExcuseOptions& options = {});

/// How a predicate is said: "{0} is on {1}", "{0} is not on {1}".
struct PredicateWords {
  std::string when_true;
  std::string when_false;
};
/// By the predicate's name; others are said as "on(a, b)", "not on(a, b)".
using Words = std::map<std::string, PredicateWords>;

/// "pick-up(b) needs: b is clear; but b is not clear, and no action changes
/// that"
std::string Explain(const Excuse& excuse, const GroundTask& task,
                    const Words& words = {});

}  // namespace cell::planning
