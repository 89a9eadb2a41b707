#include "services/cell/commands/rules_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/task/reference_rules.h"
#include "common/task/shipped_experiences.h"
#include "common/text/counted.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/learning/rule_comparison.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/running/progress.h"
#include "services/planner/plan_search.h"

namespace cell::cli {
namespace {

using planner::PlanSearch;

struct CompareOptions {
  std::string deploy_dir;
  std::string reference;
  std::string experiences;
  std::string goal;
  int max_states = 20'000;
};

/// Both rule sets, and states to compare them in.
struct Comparison {
  Domain domain;
  std::shared_ptr<const RuleSet> reference;
  std::shared_ptr<const RuleSet> learned;
  std::vector<State> states;
};

std::vector<State> StatesOfExperiences(const std::filesystem::path& folder,
                                       const RuleWorld& world) {
  std::vector<State> states;
  for (const rules::Experience& e : TaskExperiences(folder, world)) {
    states.push_back(world.FromWorld(e.before));
    states.push_back(world.FromWorld(e.after));
  }
  return states;
}

Comparison LoadComparison(const CompareOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  const Config reference_file = Config::Load(options.reference);
  const auto folder = options.experiences.empty()
                          ? deployment.task_dir / kExperiencesFolder
                          : std::filesystem::path(options.experiences);
  Comparison comparison{LoadTask(deployment).domain, {}, {}, {}};
  const Domain& domain = comparison.domain;
  comparison.learned = RuleSet::FromDomain(domain);
  comparison.reference =
      RuleSet::FromDomain(WithReferenceRules(domain, reference_file));
  const auto starts = StatesOfExperiences(folder, RuleWorldOf(domain));
  comparison.states = StatesFrom(starts, *comparison.reference, Agent::kPerson,
                                 static_cast<size_t>(options.max_states));
  return comparison;
}

void PrintActions(const RuleComparison& comparison) {
  std::cout << fmt::format("{:<20} {:>8} {:>8} {:>10} {:>8}\n", "action",
                           "both", "same", "reference", "learned");
  for (const auto& [name, action] : comparison.actions()) {
    std::cout << fmt::format(
        "{:<20} {:>8} {:>8} {:>10} {:>8}\n", name, action.num_both,
        action.num_same, action.num_reference_only, action.num_learned_only);
    for (const auto& [text, count] : action.differences) {
      std::cout << fmt::format("  {:>8}  {}\n", count, text);
    }
  }
}

/// Plans by the learned rules, held against those by the reference.
struct PlanCounts {
  int64_t num_same = 0;     ///< as many steps, or none by both
  int64_t num_shorter = 0;  ///< fewer by the learned rules
  int64_t num_longer = 0;
  int64_t num_lost = 0;     ///< no plan by the learned rules only
  int64_t num_gained = 0;   ///< no plan by the reference only
  int64_t num_invalid = 0;  ///< the first step is impossible by the reference
};

bool IsPossible(const RuleSet& rules, const GroundAction& action,
                const State& state) {
  return ApplicableRules(rules.ActionOf(action), action.arguments, state,
                         rules.vocabulary(), Agent::kPerson)
             .size() == 1;
}

void Count(const planner::Plan& reference, const planner::Plan& learned,
           bool is_invalid, PlanCounts* counts) {
  counts->num_invalid += is_invalid;
  if (reference.leads_to_goal() != learned.leads_to_goal()) {
    ++(reference.leads_to_goal() ? counts->num_lost : counts->num_gained);
  } else if (learned.steps.size() == reference.steps.size()) {
    ++counts->num_same;
  } else {
    ++(learned.steps.size() < reference.steps.size() ? counts->num_shorter
                                                     : counts->num_longer);
  }
}

PlanCounts ComparePlans(const Comparison& comparison, const Goal& goal,
                        Progress* progress) {
  PlanSearch reference({comparison.reference, goal, Agent::kPerson}, {});
  PlanSearch learned({comparison.learned, goal, Agent::kPerson}, {});
  PlanCounts counts;
  int64_t number = 0;
  for (const State& state : comparison.states) {
    progress->Show(
        fmt::format("plan {} of {}", ++number, comparison.states.size()));
    const planner::Plan plan = learned.Find(state);
    const bool is_invalid =
        !plan.steps.empty() &&
        !IsPossible(*comparison.reference, plan.steps[0].action, state);
    Count(reference.Find(state), plan, is_invalid, &counts);
  }
  progress->Clear();
  return counts;
}

int CompareRules(const CompareOptions& options) {
  Progress progress;
  progress.Show("reading");
  const Comparison comparison = LoadComparison(options);
  const Goal& goal = NamedGoal(comparison.domain, options.goal);
  RuleComparison rules(comparison.reference, comparison.learned,
                       Agent::kPerson);
  for (const State& state : comparison.states) rules.Add(state);
  progress.Clear();
  PrintActions(rules);
  const PlanCounts plans = ComparePlans(comparison, goal, &progress);
  std::cout << fmt::format(
      "{}; plans to the goal {}: {} as long as by the reference, {} shorter, "
      "{} longer, {} lost, {} gained; {} begin with what the reference does "
      "not allow\n",
      Counted(static_cast<int64_t>(comparison.states.size()), "state"),
      goal.name, plans.num_same, plans.num_shorter, plans.num_longer,
      plans.num_lost, plans.num_gained, plans.num_invalid);
  return 0;
}

}  // namespace

void AddRulesCompare(CLI::App& rules, Action* action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = rules.add_subcommand(
      "compare",
      "Compare the rules that a task plans with to those of its author, in all "
      "states of the experiences and all that the author's rules lead to: what "
      "is possible by one of them only, and why; what success changes; plans.\n"
      "Example: cell rules compare author.yaml");
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command
      ->add_option("reference", options->reference,
                   "file of actions with the author's rules, as in domain.yaml")
      ->required();
  command->add_option("--experiences", options->experiences,
                      "folder of *.experiences (default: experiences/ of the "
                      "task)");
  command->add_option("--goal", options->goal,
                      "of the plans (default: the first of the task)");
  command->add_option("--max-states", options->max_states, "compare in so many")
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return CompareRules(*options);
    };
  });
}

}  // namespace cell::cli
