#include "services/cell/explaining/alternative_reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "common/text/counted.h"
#include "services/cell/explaining/rule_reasons.h"
#include "services/planner/outcome_prediction.h"

namespace cell::cli {
namespace {

using planner::Alternative;
using planner::DecisionBasis;

constexpr size_t kNumAlternatives =
    3;  // that are shown unless all are asked for

std::string ValueOf(const Alternative& alternative) {
  return fmt::format(
      "reaches the goal with probability {:.2f}, {:.2f} actions expected",
      alternative.probability, alternative.step.expected_actions);
}

/// "as good, later in order", "2.00 more".
std::string ComparedWith(const Alternative& chosen, const Alternative& other) {
  if (other.probability < chosen.probability) return "less likely";
  const double more =
      other.step.expected_actions - chosen.step.expected_actions;
  if (more >= 0.005) return fmt::format("{:.2f} more", more);
  if (more > 0) return "a little more";
  return "as good; of equals the first in the order of actions is taken";
}

void AddOthers(const DecisionBasis& basis, const Alternative& chosen,
               const std::vector<Alternative>& others, bool is_verbose,
               Reasons* lines) {
  size_t num_shown = 0;
  for (const Alternative& other : others) {
    if (num_shown == kNumAlternatives && !is_verbose) break;
    lines->push_back(fmt::format("{}: {} {}: {}",
                                 num_shown == 0 ? "next best" : "then",
                                 basis.problem.rules->Show(other.step.action),
                                 ValueOf(other), ComparedWith(chosen, other)));
    ++num_shown;
  }
  if (others.empty()) {
    lines->emplace_back("no other action leads to the goal from here");
  } else if (num_shown < others.size()) {
    lines->push_back(
        fmt::format("and {} more that lead to the goal (--verbose)",
                    others.size() - num_shown));
  }
}

/// Why no plan leads on from where the action most likely leads.
std::string WhyNowhere(const DecisionBasis& basis, planner::Solver& solver,
                       const GroundAction& action) {
  const auto after = planner::MostLikelyOutcome(
      *basis.problem.rules, action, basis.state, basis.problem.agent);
  return after ? solver.Find(*after).reason : "";
}

void AddRejected(const DecisionBasis& basis, planner::Solver& solver,
                 const std::vector<Alternative>& possible, Reasons* lines) {
  const RuleSet& rules = *basis.problem.rules;
  std::set<GroundAction> told;
  for (const Alternative& alternative : possible) {
    const GroundAction& action = alternative.step.action;
    if (!told.insert(action).second || alternative.probability > 0) continue;
    lines->push_back(fmt::format("leads nowhere: {}: {}", rules.Show(action),
                                 WhyNowhere(basis, solver, action)));
  }
  for (const GroundAction& action : rules.GroundActions(basis.problem.agent)) {
    if (told.contains(action)) continue;
    lines->push_back(
        fmt::format("not possible: {} {}", rules.Show(action),
                    basis.problem.blocked.contains(action)
                        ? "has failed too often"
                        : WhyNotPossible(basis.problem, action,
                                         basis.state.UnknownAsFalse())));
  }
}

}  // namespace

Reasons AlternativeReasons(const DecisionBasis& basis,
                           const GroundAction& chosen, bool is_verbose) {
  Reasons lines;
  const auto solver = basis.make_solver(basis.problem);
  const auto all = solver->Alternatives(basis.state);
  const auto own = std::ranges::find_if(
      all, [&](const Alternative& a) { return a.step.action == chosen; });
  if (own != all.end()) {
    lines.push_back(
        fmt::format("it {}; it counts on an outcome of "
                    "probability {:.2f}",
                    ValueOf(*own), own->step.probability));
    std::vector<Alternative> others = all;
    std::erase_if(others, [&](const Alternative& a) {
      return a.step.action == chosen || a.probability <= 0;
    });
    AddOthers(basis, *own, others, is_verbose, &lines);
  }
  if (is_verbose) AddRejected(basis, *solver, all, &lines);
  return lines;
}

Reasons FailureReasons(const DecisionBasis& basis) {
  Reasons lines;
  for (const auto& [action, failed] : basis.failures) {
    lines.push_back(fmt::format(
        "{} has failed {} in this state{}: {}",
        basis.problem.rules->Show(action), Counted(failed.count, "time"),
        basis.problem.blocked.contains(action) ? " and is not counted on" : "",
        failed.reason));
  }
  return lines;
}

}  // namespace cell::cli
