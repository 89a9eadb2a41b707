#pragma once

#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "common/relational/domain.h"
#include "common/relational/rule_set.h"
#include "services/planner/plan.h"

namespace cell::planner {

/// What a solver finds plans for.
struct Problem {
  std::shared_ptr<const RuleSet> rules;
  Goal goal;
  Agent agent = Agent::kPerson;         ///< of the plan
  std::set<GroundAction> blocked = {};  ///< not to be counted on
};

/// Finds the best plan of one problem from any state (section VIII-A). May keep
/// what it has found out for later questions; answers do not depend on it.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// Unknown atoms are taken as false; if there is a plan only if some are
  /// true, the result is undecided.
  virtual Plan Find(const State& state) = 0;
  /// The same, but not why there is none.
  virtual Plan FindWithoutReason(const State& state) = 0;
  /// All actions that may change the state, those that lead nowhere last.
  /// Unknown atoms are taken as false. Empty if the solver cannot tell.
  virtual std::vector<Alternative> Alternatives(const State&) { return {}; }
};

/// Makes the solver of a problem, with a budget of its own kind.
using SolverMaker = std::function<std::unique_ptr<Solver>(Problem)>;

}  // namespace cell::planner
