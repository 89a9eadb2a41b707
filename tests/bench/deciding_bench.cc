// How long the planner takes for a decision about the shipped task, and for
// learning from one more experience before it, as it does while the cell runs.
// And what a cell that learns remembers.
#include <fmt/format.h>
#include <malloc.h>
#include <time.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "common/task/shipped_experiences.h"
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

/// Of one core, whatever else the machine does.
double Milliseconds(const std::function<void()>& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

double Percentile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<size_t>(share * last)];
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

using Experiences = std::vector<TaskExperience>;

/// In an order in which any action may be the next.
Experiences Shuffled(Experiences experiences) {
  std::mt19937_64 random(1);
  std::ranges::shuffle(experiences, random);
  return experiences;
}

/// What decisions took, those that lead to a plan and those that explain why
/// there is none. [ms]
class DecisionTimes {
 public:
  void Decide(const State& state, CurrentPlan* plan) {
    const double time = Milliseconds([&] { plan->Find(state, {}); });
    const bool is_question =
        plan->get().result == planner::Plan::Result::kNoPlan;
    (is_question ? questions_ : decisions_).push_back(time);
  }
  void Print(const std::string& when) const {
    if (!decisions_.empty()) {
      PrintFigure({.name = "decision " + when + ", p99",
                   .value = Percentile(decisions_, 0.99),
                   .unit = "ms",
                   .goal = 5});
    }
    if (!questions_.empty()) {
      PrintFigure({.name = "question " + when + ", p99",
                   .value = Percentile(questions_, 0.99),
                   .unit = "ms"});
    }
  }

 private:
  std::vector<double> decisions_, questions_;
};

/// Each experience is learned from, and the next action is decided on. The last
/// `num_timed` count.
void Learn(const std::string& name, Knowledge knowledge,
           const Experiences& experiences, size_t num_timed) {
  const Domain domain = knowledge.domain();
  CurrentPlan plan(RuleSet::FromDomain(domain), *domain.FindGoal("assembled"),
                   PlanSearch::Maker({}));
  std::vector<double> learning;
  DecisionTimes deciding;
  for (size_t i = 0; i < experiences.size(); ++i) {
    knowledge.Add(static_cast<int64_t>(i + 1), experiences[i]);
    if (i + num_timed < experiences.size()) continue;
    learning.push_back(Milliseconds([&] {
      plan.SetRules(knowledge.TakeChange(static_cast<int64_t>(i + 2)));
    }));
    deciding.Decide(WithinReach(experiences[i].after, domain.vocabulary()),
                    &plan);
  }
  // The first has learned from all before.
  if (num_timed < experiences.size()) learning.erase(learning.begin());
  PrintFigure({.name = "learning from " + name + ", p99",
               .value = Percentile(learning, 0.99),
               .unit = "ms",
               .goal = 50});
  deciding.Print("after " + name);
}

/// From nothing.
void LearnFromNothing(const Deployment& deployment, const Experiences& all) {
  const Domain domain = LoadTask(deployment, LearnedRules::kLeaveOut).domain;
  for (const size_t number : {20, 50, 100, 200, 400, 800}) {
    const auto end =
        all.begin() + static_cast<std::ptrdiff_t>(std::min(number, all.size()));
    Learn(fmt::format("the {}th experience", number), Knowledge(domain, true),
          {all.begin(), end}, std::min<size_t>(number, 100));
  }
}

/// From experiences of the action that has most.
void LearnOneAction(const Deployment& deployment, const Experiences& all) {
  const Domain domain = LoadTask(deployment, LearnedRules::kLeaveOut).domain;
  std::map<std::string, Experiences> of_action;
  for (const TaskExperience& e : all) of_action[e.action].push_back(e);
  const auto most = std::ranges::max_element(
      of_action, {}, [](const auto& entry) { return entry.second.size(); });
  Learn(fmt::format("the {}th experience of {}", most->second.size(),
                    most->first),
        Knowledge(domain, true), most->second, 50);
}

/// Beside all that the task ships with.
void LearnBesideShipped(const Deployment& deployment, const Experiences& all) {
  const Domain domain = LoadTask(deployment).domain;
  std::optional<Knowledge> knowledge;
  PrintFigure({.name = "learning all shipped experiences at the start",
               .value = Milliseconds([&] {
                 knowledge.emplace(domain, true, all);
                 knowledge->TakeChange(1);
               }),
               .unit = "ms"});
  Learn("one beside the shipped ones", *knowledge,
        {all.begin(), all.begin() + 100}, 100);
}

/// [MB] what the program has asked for.
double HeapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) * 1e-6;
}

/// What an assembly teaches: nine placements and some that failed.
constexpr int64_t kPerEpisode = 12;
/// As many as a library keeps.
constexpr int64_t kMostKept = 2000;

/// What grows with the episodes of a cell that learns.
void Remember(const Deployment& deployment, const Experiences& all) {
  const Domain domain = LoadTask(deployment).domain;
  const double before = HeapInUse();
  Knowledge knowledge(domain, true, all);
  CurrentPlan plan(RuleSet::FromDomain(domain), *domain.FindGoal("assembled"),
                   PlanSearch::Maker({}));
  int64_t id = 0;
  for (int episode = 1; episode <= 200; ++episode) {
    for (int i = 0; i < kPerEpisode; ++i) {
      ++id;
      knowledge.Add(id, all[static_cast<size_t>(id) % all.size()]);
      if (id > kMostKept) knowledge.Remove(id - kMostKept);
    }
    plan.SetRules(knowledge.TakeChange(episode + 1));
    plan.Find(WithinReach(all[0].before, domain.vocabulary()), {});
    if (episode != 1 && episode != 10 && episode != 100 && episode != 200) {
      continue;
    }
    PrintFigure({.name = fmt::format("memory of a planner that learns after {} "
                                     "episodes",
                                     episode),
                 .value = HeapInUse() - before,
                 .unit = "MB"});
  }
}

/// Of the shipped rules, in every state of the shipped experiences; the first
/// one finds all reachable states.
void Decide(const Deployment& deployment) {
  const Domain domain = LoadTask(deployment).domain;
  const Experiences all = ReadShippedExperiences(deployment, domain);
  CurrentPlan plan(RuleSet::FromDomain(domain), *domain.FindGoal("assembled"),
                   PlanSearch::Maker({}));
  const State start = WithinReach(all.front().before, domain.vocabulary());
  PrintFigure({.name = "first decision by the shipped rules",
               .value = Milliseconds([&] { plan.Find(start, {}); }),
               .unit = "ms",
               .goal = 5});
  DecisionTimes deciding;
  for (const TaskExperience& experience : all) {
    deciding.Decide(WithinReach(experience.before, domain.vocabulary()), &plan);
  }
  deciding.Print("by the shipped rules");
}

}  // namespace
}  // namespace cell

int main() {
  const cell::Deployment deployment{CELL_SOURCE_DIR "/deploy/config",
                                    CELL_SOURCE_DIR "/deploy/tasks/cranfield",
                                    {}};
  cell::Decide(deployment);
  const auto all = cell::Shuffled(cell::ReadShippedExperiences(
      deployment, cell::LoadTask(deployment).domain));
  cell::LearnFromNothing(deployment, all);
  cell::LearnOneAction(deployment, all);
  cell::LearnBesideShipped(deployment, all);
  cell::Remember(deployment, all);
}
