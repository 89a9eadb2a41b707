#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/relational/domain.h"
#include "common/task/reference_rules.h"
#include "common/task/task.h"
#include "services/planner/plan_search.h"
#include "services/planner/planner.h"
#include "services/planner/planner_config.h"

namespace cell {

using namespace planner;

/// The shipped task with the rules of its author, and how a person changes its
/// state.
struct Cranfield {
  Cranfield() {
    domain = std::make_unique<Domain>(WithReferenceRules(
        LoadTask(deployment, LearnedRules::kLeaveOut).domain,
        Config::Load(CELL_SOURCE_DIR
                     "/tests/data/cranfield/reference_rules.yaml")));
    rules = RuleSet::FromDomain(*domain);
  }

  /// The service that plans with these rules.
  std::unique_ptr<Service> MakePlannerOfRules(Bus& bus) const {
    return std::make_unique<Planner>(bus, Knowledge(*domain, false),
                                     std::set<std::string>{},
                                     LoadDecisionMaker(*domain, deployment));
  }
  Problem ProblemOf(Agent agent) const {
    return {rules, *domain->FindGoal("assembled"), agent};
  }
  PlanSearch Search() const {
    return PlanSearch(ProblemOf(Agent::kPerson), {});
  }

  int Atom(const std::string& name) const {
    for (int i = 0; i < domain->vocabulary().num_atoms(); ++i) {
      if (domain->vocabulary().AtomName(i) == name) return i;
    }
    ADD_FAILURE() << "no atom " << name;
    return 0;
  }

  /// All parts stand clear on the table, all holes are free.
  State Start() const {
    const Vocabulary& v = domain->vocabulary();
    State state(v.num_atoms());
    for (int i = 0; i < v.num_atoms(); ++i) {
      const std::string& name = v.predicates()[v.Atom(i).predicate].name;
      if (name == "Clear" || name == "Free") state.Set(i, Truth::kTrue);
    }
    return state;
  }

  /// The same, and the arm could take every part.
  State StartWithin(const std::string& arm) const {
    const Vocabulary& v = domain->vocabulary();
    State state = Start();
    for (int i = 0; i < v.num_atoms(); ++i) {
      if (v.AtomName(i).starts_with("Reachable(" + arm)) {
        state.Set(i, Truth::kTrue);
      }
    }
    return state;
  }

  State With(State state, const std::vector<std::string>& atoms,
             Truth truth = Truth::kTrue) const {
    for (const std::string& name : atoms) state.Set(Atom(name), truth);
    return state;
  }

  std::vector<ApplicableRule> RulesFor(const GroundAction& action,
                                       const State& state) const {
    return ApplicableRules(domain->actions()[action.action], action.arguments,
                           state, domain->vocabulary(), Agent::kPerson);
  }

  /// The state after the action succeeds.
  State Do(const State& state, const GroundAction& action) const {
    const auto applicable = RulesFor(action, state);
    if (applicable.size() != 1) {
      ADD_FAILURE() << domain->Show(action) << " is covered by "
                    << applicable.size() << " rules";
      return state;
    }
    const NdrRule& rule =
        domain->actions()[action.action].rules[applicable[0].rule];
    return Apply(rule.outcomes[0], applicable[0].binding, state,
                 domain->vocabulary());
  }
  State Do(const State& state, const std::string& action,
           const std::vector<std::string>& objects) const {
    return Do(state, domain->FindGroundAction(action, objects).value());
  }

  /// Placing actions that can be done now.
  std::vector<GroundAction> Placements(const State& state) const {
    std::vector<GroundAction> found;
    for (const GroundAction& a : domain->GroundActions(Agent::kRobot)) {
      if (!RulesFor(a, state).empty()) found.push_back(a);
    }
    return found;
  }

  /// A valid order of all nine placements.
  std::vector<GroundAction> RandomOrder(std::mt19937_64& random) const {
    std::vector<GroundAction> order;
    State state = Start();
    for (auto all = Placements(state); !all.empty(); all = Placements(state)) {
      order.push_back(all[random() % all.size()]);
      state = Do(state, order.back());
    }
    return order;
  }

  const Deployment deployment{CELL_SOURCE_DIR "/deploy/config",
                              CELL_SOURCE_DIR "/deploy/tasks/cranfield"};
  std::unique_ptr<Domain> domain;
  std::shared_ptr<const RuleSet> rules;
};

}  // namespace cell
