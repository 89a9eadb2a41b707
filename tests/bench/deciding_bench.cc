// How long the planner takes for a decision about the shipped task, and for
// learning from one more experience before it, as it does while the cell runs.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "common/experiences/experience_text.h"
#include "common/experiences/rule_world.h"
#include "common/task/task.h"
#include "services/planner/current_plan.h"
#include "services/planner/knowledge.h"
#include "services/planner/plan_search.h"
#include "tests/bench/figure.h"

namespace cell {
namespace {

using planner::CurrentPlan;
using planner::Knowledge;
using planner::PlanSearch;

double Milliseconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now() - begin)
      .count();
}

double Percentile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<size_t>(share * last)];
}

std::vector<TaskExperience> ShippedExperiences(const Deployment& deployment,
                                               const Domain& domain) {
  const RuleWorld world(std::make_shared<const Vocabulary>(domain.vocabulary()),
                        domain.actions());
  std::vector<TaskExperience> experiences;
  for (const char* name : {"assembly", "execution"}) {
    const std::string file = std::string(name) + ".experiences";
    std::stringstream text;
    text << std::ifstream(deployment.task_dir / "experiences" / file).rdbuf();
    for (const auto& e : ReadExperiences(text.str(), file, world)) {
      const GroundAction action = world.FromWorld(e.act);
      experiences.push_back(
          {domain.actions()[static_cast<size_t>(action.action)].name,
           action.arguments, Agent::kPerson, world.FromWorld(e.before),
           world.FromWorld(e.after)});
    }
  }
  return experiences;
}

/// The state in which every arm can take every part.
State WithinReach(State state, const Vocabulary& vocabulary) {
  for (int i = 0; i < vocabulary.num_atoms(); ++i) {
    const auto predicate = static_cast<size_t>(vocabulary.Atom(i).predicate);
    if (vocabulary.predicates()[predicate].report ==
        Predicate::Report::kReachable) {
      state.Set(i, Truth::kTrue);
    }
  }
  return state;
}

/// Each experience is learned from, and the next action is decided on.
void Learn(const Deployment& deployment, size_t num_experiences) {
  const Domain domain = LoadTask(deployment, LearnedRules::kLeaveOut).domain;
  const auto experiences = ShippedExperiences(deployment, domain);
  Knowledge knowledge(domain, true);
  CurrentPlan plan(RuleSet::FromDomain(domain), *domain.FindGoal("assembled"),
                   PlanSearch::Maker({}));
  std::vector<double> learning, deciding;
  for (size_t i = 0; i < num_experiences; ++i) {
    const TaskExperience& experience = experiences[i % experiences.size()];
    learning.push_back(Milliseconds([&] {
      knowledge.Add(static_cast<int64_t>(i + 1), experience);
      plan.SetRules(knowledge.TakeChange(static_cast<int64_t>(i + 2)));
    }));
    deciding.push_back(Milliseconds([&] {
      plan.Find(WithinReach(experience.after, domain.vocabulary()), {});
    }));
  }
  PrintFigure({.name = fmt::format("learning from the {}th experience, p99",
                                   num_experiences),
               .value = Percentile(learning, 0.99),
               .unit = "ms",
               .goal = 50});
  PrintFigure({.name = fmt::format("decision after {} experiences, p99",
                                   num_experiences),
               .value = Percentile(deciding, 0.99),
               .unit = "ms",
               .goal = 5});
}

/// Of the shipped rules, in every state of the shipped experiences; the first
/// one finds all reachable states.
void Decide(const Deployment& deployment) {
  const Domain domain = LoadTask(deployment).domain;
  CurrentPlan plan(RuleSet::FromDomain(domain), *domain.FindGoal("assembled"),
                   PlanSearch::Maker({}));
  std::vector<double> times;
  for (const auto& experience : ShippedExperiences(deployment, domain)) {
    times.push_back(Milliseconds([&] {
      plan.Find(WithinReach(experience.before, domain.vocabulary()), {});
    }));
  }
  PrintFigure({.name = "first decision by the shipped rules",
               .value = times.front(),
               .unit = "ms"});
  PrintFigure({.name = "decision by the shipped rules, p99",
               .value = Percentile(times, 0.99),
               .unit = "ms",
               .goal = 5});
}

}  // namespace
}  // namespace cell

int main() {
  const cell::Deployment deployment{CELL_SOURCE_DIR "/deploy/config",
                                    CELL_SOURCE_DIR "/deploy/tasks/cranfield",
                                    {}};
  cell::Decide(deployment);
  for (const size_t number : {20, 50, 100, 200}) {
    cell::Learn(deployment, number);
  }
}
