#include "services/cell/evaluations/alarms_evaluation.h"

#include <algorithm>
#include <map>
#include <string>

#include "common/task/task.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/cell/scoring/alarm_score.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

using nlohmann::json;

// Keys of `watched` in the task's demonstrators.yaml.
constexpr char kCorrect[] = "correct", kDeviation[] = "deviation",
               kDeadEnd[] = "dead_end";
constexpr double kPlantedShare = 0.75;  // of the number of correct runs

json RowOf(const AlarmScore& score) {
  return {{"actions", score.num_actions},
          {"warnings_due", score.num_warnings_due},
          {"warned", score.num_warned},
          {"errors_due", score.num_errors_due},
          {"called_errors", score.num_called_errors},
          {"missed", score.num_missed},
          {"of_wrong_level", score.num_of_wrong_level},
          {"late", score.num_late},
          {"false", score.num_false},
          {"most_key_frames", score.most_key_frames},
          {"most_seconds", score.most_seconds},
          {"remarks", score.remarks}};
}

bool IsFaultless(const json& row) {
  return row.at("remarks").empty();
}

/// Sums and maxima over the rows of a script.
struct ScriptFigures {
  int runs = 0, faultless = 0;
  double most_key_frames = 0, most_seconds = 0;
};

std::map<std::string, ScriptFigures> FiguresByScript(
    const std::vector<json>& rows) {
  std::map<std::string, ScriptFigures> all;
  for (const json& row : rows) {
    ScriptFigures& figures = all[row.at("group").get<std::string>() + ": " +
                                 row.at("script").get<std::string>()];
    ++figures.runs;
    figures.faultless += IsFaultless(row);
    figures.most_key_frames = std::max(figures.most_key_frames,
                                       row.at("most_key_frames").get<double>());
    figures.most_seconds =
        std::max(figures.most_seconds, row.at("most_seconds").get<double>());
  }
  return all;
}

class AlarmsEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "alarms"; }
  std::string description() const override {
    return "Watch correct orders, deviations and dead ends: what the person "
           "is told, and how soon.\n"
           "The scripts of each group are those of `watched` in the task's "
           "demonstrators.yaml, in turn.";
  }
  int default_runs() const override { return 80; }

  std::vector<TrialGroup> groups() const override {
    return {{kCorrect}, {kDeviation, kPlantedShare}, {kDeadEnd, kPlantedShare}};
  }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const Task task = LoadTask(deployment);
    const Config config = deployment.OfTask("demonstrators.yaml");
    const auto demonstrations =
        vtb::Demonstrations::FromConfig(config, task.parts);
    const auto scripts = demonstrations.watched.find(trial.group);
    if (scripts == demonstrations.watched.end()) {
      config["watched"].Fail("is missing: cell eval alarms needs it");
    }
    const std::string& script =
        scripts->second[trial.seed % scripts->second.size()];
    EpisodeObserver observer;
    SimBus bus(roster, AllServices(deployment, script, trial.seed));
    RunToEnd(bus, [&](const Message& message) { observer.Put(message); });
    json row = RowOf(ScoreAlarms(observer.record(),
                                 TrueProgress(demonstrations, task.parts)));
    row["script"] = script;
    row["seconds"] = static_cast<double>(observer.record().last_utime) * 1e-6;
    return row;
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    return RowShape::Counts({"actions", "warnings_due", "warned", "errors_due",
                             "called_errors"})
        .With({{"most_key_frames", kNumber},
               {"most_seconds", kNumber},
               {"remarks", RowShape::ListOf(kText)},
               {"script", kText}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures = {
        ShareOf(rows, kDeviation, "deviations warned within one key frame",
                "warned", "warnings_due"),
        ShareOf(rows, kDeadEnd,
                "dead ends called an error within one key frame",
                "called_errors", "errors_due"),
        RunsOf(rows, kCorrect, "runs without an alarm",
               [](const json& row) {
                 return row.at("warnings_due") == 0 &&
                        row.at("errors_due") == 0 && row.at("actions") > 0 &&
                        IsFaultless(row);
               }),
        // What was to be a deviation may jam, and then is a dead end.
        RunsOf(rows, kDeviation, "runs with all told, and no other alarm",
               [](const json& row) {
                 return (row.at("warnings_due") > 0 ||
                         row.at("errors_due") > 0) &&
                        IsFaultless(row);
               }),
        RunsOf(rows, kDeadEnd, "runs with an error, and no other alarm",
               [](const json& row) {
                 return row.at("errors_due") > 0 && IsFaultless(row);
               })};
    return measures;
  }

  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    std::vector<Figure> figures;
    for (const auto& [name, of_script] : FiguresByScript(rows)) {
      figures.push_back(
          {name + ", faultless runs of " + std::to_string(of_script.runs),
           static_cast<double>(of_script.faultless), "runs"});
      if (of_script.most_seconds == 0) continue;
      figures.push_back({name + ", longest from the action's key frame",
                         of_script.most_key_frames, "key frames"});
      figures.push_back(
          {name + ", longest from letting go", of_script.most_seconds, "s"});
    }
    return figures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeAlarmsEvaluation() {
  return std::make_unique<AlarmsEvaluation>();
}

}  // namespace cell::cli
