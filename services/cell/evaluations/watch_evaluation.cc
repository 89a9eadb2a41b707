#include "services/cell/evaluations/watch_evaluation.h"

#include <array>

#include "services/cell/evaluations/row_measures.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/cell/scoring/episode_score.h"

namespace cell::cli {
namespace {

using nlohmann::json;

// Scripts of the task's demonstrators.yaml that every watched task provides,
// and how many runs of each belong to 100 %.
struct Group {
  const char* name;
  double share;
  std::array<const char*, 2> scripts;  // taken in turn
};
constexpr std::array<Group, 3> kGroups = {{
    {"valid", 1.0, {"assembly", "assembly_two_hands"}},
    {"taken_back", 0.4, {"take_backs", "unknown_moves"}},
    {"mistake", 1.0, {"mistake_order", "mistake_outside"}},
}};

json ToJson(const EpisodeScore& score) {
  return {{"steps", score.num_steps},
          {"steps_recognised", score.num_steps_recognised},
          {"take_backs", score.num_take_backs},
          {"take_backs_named", score.num_take_backs_named},
          {"take_backs_warned", score.num_take_backs_warned},
          {"moves", score.num_moves},
          {"moves_named", score.num_moves_named},
          {"mistakes", score.num_mistakes},
          {"mistakes_caught", score.num_mistakes_caught},
          {"invented", score.num_invented},
          {"false_alarms", score.num_false_alarms},
          {"goal_reached", score.is_goal_reached}};
}

class WatchEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "watch"; }
  std::string description() const override {
    return "Watch a person: valid orders, take-backs, planted mistakes.";
  }
  int default_runs() const override { return 50; }

  std::vector<TrialGroup> groups() const override {
    std::vector<TrialGroup> groups;
    for (const Group& group : kGroups) {
      groups.push_back(
          {group.name, group.share, static_cast<int>(group.scripts.size())});
    }
    return groups;
  }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const char* script = "";
    for (const Group& group : kGroups) {
      if (trial.group == group.name) {
        script = group.scripts[trial.seed % group.scripts.size()];
      }
    }
    SimBus bus(roster, AllServices(deployment, script, trial.seed));
    EpisodeObserver observer;
    RunToEnd(bus, [&](const Message& message) { observer.Put(message); });
    json row = ToJson(Score(observer.record()));
    row["script"] = script;
    row["seconds"] = static_cast<double>(observer.record().last_utime) * 1e-6;
    return row;
  }

  RowShape row_shape() const override {
    return RowShape::Counts({"steps", "steps_recognised", "take_backs",
                             "take_backs_named", "take_backs_warned", "moves",
                             "moves_named", "mistakes", "mistakes_caught",
                             "invented", "false_alarms"})
        .With({{"goal_reached", RowShape::kFlag}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    return {
        ShareOf(rows, "valid", "steps recognised with the right arguments",
                "steps_recognised", "steps"),
        RunsOf(rows, "valid", "runs with all recognised, none false, no alarm",
               [](const json& row) {
                 return row.at("steps_recognised") == row.at("steps") &&
                        row.at("invented") == 0 &&
                        row.at("false_alarms") == 0 &&
                        row.at("goal_reached") == true;
               }),
        ShareOf(rows, "taken_back", "take-backs recognised as the reverse",
                "take_backs_named", "take_backs"),
        ShareOf(rows, "taken_back", "take-backs with exactly one warning",
                "take_backs_warned", "take_backs"),
        ShareOf(rows, "taken_back", "unknown moves reported as unknown",
                "moves_named", "moves"),
        RunsOf(rows, "taken_back",
               "runs with all recognised, none false, no false alarm",
               [](const json& row) {
                 return row.at("steps_recognised") == row.at("steps") &&
                        row.at("invented") == 0 && row.at("false_alarms") == 0;
               }),
        ShareOf(rows, "mistake", "planted mistakes caught within one key frame",
                "mistakes_caught", "mistakes"),
        RunsOf(rows, "mistake",
               "runs with a planted mistake and no false alarm",
               [](const json& row) {
                 return row.at("mistakes") > 0 && row.at("false_alarms") == 0;
               }),
    };
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeWatchEvaluation() {
  return std::make_unique<WatchEvaluation>();
}

}  // namespace cell::cli
