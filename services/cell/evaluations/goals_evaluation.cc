#include "services/cell/evaluations/goals_evaluation.h"

#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell/asked_skill_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/skills/skill_arguments.h"
#include "common/task/task.h"
#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/scoring/seated_parts.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kGoals[] = "goals";
constexpr double kEarliest = 2, kLatest = 60;  // [s] in the episode
constexpr double kSecondsPerTick = 1e-6 * kTickUs;
constexpr int32_t kValidTicks = 10;  // of the command

/// Sets the goal at a time, and remembers what was placed by then, or was about
/// to be: the arms finish what they have begun. Reads ground truth.
class GoalChange {
 public:
  /// `success`, of the new goal, must outlive this object.
  GoalChange(const std::string& goal, double time,
             const SuccessCriterion& success, SimBus& bus)
      : tick_(static_cast<int32_t>(time / kSecondsPerTick)), success_(success) {
    command_goal_t command{};
    command.goal = goal;
    command.deadline_utime = (tick_ + kValidTicks) * kTickUs;
    bus.Schedule(
        SimBus::TimedCommand{tick_, {"COMMAND_GOAL", Bus::Encode(command)}});
  }

  void Put(const Message& message) {
    if (message.channel == "TRUTH_POSES") {
      if (auto poses = Decode<truth_poses_t>(message)) {
        looks_.Put(*std::move(poses));
      }
    } else if (message.channel == "SKILL_REQUEST") {
      if (const auto request = Decode<asked_skill_t>(message)) {
        under_way_[request->id] = ArgumentOf(*request, "site");
      }
    } else if (message.channel == "SKILL_RESULT") {
      if (const auto result = Decode<skill_result_t>(message)) {
        under_way_.erase(result->id);
      }
    }
    if (!has_changed_ && message.tick >= tick_ && looks_.has_both()) {
      has_changed_ = true;
      for (const auto& [site, part] : SeatedParts(looks_, success_)) {
        earlier_.insert(site);
      }
      for (const auto& [id, site] : under_way_) {
        if (!site.empty()) earlier_.insert(site);
      }
      num_under_way_ = static_cast<int>(under_way_.size());
    }
  }

  /// Adds to the row what is placed in the end.
  void AddTo(json* row) const {
    const auto seated = SeatedParts(looks_, success_);
    const std::set<std::string> wanted = WantedSites(success_);
    std::set<std::string> extra;
    for (const auto& [site, part] : seated) {
      if (!wanted.contains(site) && !earlier_.contains(site)) {
        extra.insert(site);
      }
    }
    (*row)["seconds_before"] = tick_ * kSecondsPerTick;
    (*row)["skills_at_change"] = num_under_way_;
    (*row)["sites_before"] = earlier_;
    (*row)["extra"] = extra;
    (*row)["in_the_way"] = PartsInTheWay(seated, success_);
  }

 private:
  int32_t tick_;
  const SuccessCriterion& success_;
  PoseHistory looks_;
  std::map<int64_t, std::string> under_way_;  // site by request
  bool has_changed_ = false;
  std::set<std::string> earlier_;
  int num_under_way_ = 0;
};

/// What has to be taken out first is all that is asked for.
bool IsReachedOrAskedFor(const json& row) {
  if (!row.at("in_the_way").empty()) {
    return row.at("state") == "stuck" &&
           row.at("named") == row.at("in_the_way");
  }
  return row.at("complete") && row.at("state") == "done";
}

class GoalsEvaluation final : public Evaluation {
 public:
  std::string name() const override { return kGoals; }
  std::string description() const override {
    return "Change the goal while the arms assemble: to each other goal of "
           "domain.yaml in turn.\n"
           "Where parts that are placed already exclude the new goal, a "
           "question that names just these is success.";
  }
  int default_runs() const override { return 24; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const Task task = LoadTask(deployment);
    const std::string goal = GoalOf(task, deployment, trial.seed);
    const auto success =
        SuccessCriterion::Load(deployment).ForGoal(*task.domain.FindGoal(goal));
    std::mt19937_64 random(trial.seed);
    const double time =
        std::uniform_real_distribution<double>(kEarliest, kLatest)(random);
    std::unique_ptr<GoalChange> change;
    json row = RunAssembly(
        kExecutionScript, trial.seed, deployment, roster,
        [&](SimBus& bus) {
          change = std::make_unique<GoalChange>(goal, time, success, bus);
          return [&](const Message& message) {
            change->Put(message);
          };
        },
        goal);
    row["goal"] = goal;
    change->AddTo(&row);
    return row;
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    return AssemblyRowShape().With({{"goal", kText},
                                    {"extra", RowShape::ListOf(kText)},
                                    {"in_the_way", RowShape::ListOf(kText)}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    return {
        RunsOf(rows, kGoals,
               "runs that reach the new goal, or ask for what excludes it",
               IsReachedOrAskedFor),
        RunsOf(rows, kGoals, "runs in which nothing else is placed",
               [](const json& row) { return row.at("extra").empty(); }),
        RunsOf(rows, kGoals, "runs without a breach of limits", HasKeptLimits),
        RunsOf(rows, kGoals, "runs without a collision", HasHitNothing)};
  }

  /// By goal: runs, those that reach it, those that end with a question.
  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    std::map<std::string, std::map<std::string, int>> num;
    for (const json& row : rows) {
      auto& of_goal = num[row.at("goal")];
      ++of_goal["runs"];
      of_goal["runs done"] += row.at("complete") && row.at("state") == "done";
      of_goal["runs with a question"] += row.at("state") == "stuck";
    }
    std::vector<Figure> figures;
    for (const auto& [goal, of_goal] : num) {
      for (const auto& [what, n] : of_goal) {
        figures.push_back(
            {std::string(kGoals) + ": " + goal, static_cast<double>(n), what});
      }
    }
    return figures;
  }

 private:
  static std::string GoalOf(const Task& task, const Deployment& deployment,
                            uint64_t seed) {
    const auto first =
        deployment.OfTask("demonstrators.yaml").Get<std::string>("goal");
    std::vector<std::string> others;
    for (const Goal& goal : task.domain.goals()) {
      if (goal.name != first) others.push_back(goal.name);
    }
    if (others.empty()) {
      throw std::runtime_error(deployment.task_dir.string() +
                               ": domain.yaml has no goal besides " + first);
    }
    return others[seed % others.size()];
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeGoalsEvaluation() {
  return std::make_unique<GoalsEvaluation>();
}

}  // namespace cell::cli
