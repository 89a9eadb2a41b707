#include "services/cell/evaluations/stops_evaluation.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "common/task/task.h"
#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/evaluations/stop_injector.h"

namespace cell::cli {

namespace {

using nlohmann::json;

constexpr char kGroup[] = "stops";
constexpr double kMm = 1e3;
constexpr double kStays = 0.5;  // [mm] that what is placed may move

json ToJson(const MadeStop& stop) {
  return {{"kind", NameOf(stop.kind)},
          {"tick", stop.tick},
          {"ticks", stop.end_tick - stop.tick},
          {"arm", stop.arm},
          {"part", stop.part},
          {"stage", stop.stage},
          {"moved_part", stop.moved_part},
          {"moved_mm", kMm * stop.moved}};
}

/// Stops of a kind, and those after which nothing placed has moved.
Measure StopsOf(const std::vector<json>& rows, StopKind kind) {
  Measure measure{.name = std::string(kGroup) + ": no placed part moved, " +
                          NameOf(kind)};
  for (const json& row : rows) {
    for (const json& stop : row.at("stops")) {
      if (stop.at("kind") != NameOf(kind)) continue;
      measure.num_good += stop.at("moved_mm") <= kStays;
      ++measure.num_all;
    }
  }
  return measure;
}

class StopsEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "stops"; }
  std::string description() const override {
    return "Stop the arms at every stage of every skill while they assemble.";
  }
  int default_runs() const override { return 24; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const auto success = SuccessCriterion::Load(deployment);
    std::unique_ptr<StopInjector> injector;
    json row = RunAssembly(
        kExecutionScript, trial.seed, deployment, roster, [&](SimBus& bus) {
          injector = std::make_unique<StopInjector>(bus, success, trial.seed);
          return [&](const Message& message) {
            injector->Put(message);
          };
        });
    json& stops = row["stops"] = json::array();
    for (const MadeStop& stop : injector->stops()) {
      stops.push_back(ToJson(stop));
    }
    return row;
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    return AssemblyRowShape().With(
        {{"stops",
          RowShape::ListOf(RowShape::Record(
              {{"kind", kText}, {"stage", kText}, {"moved_mm", kNumber}}))}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    return {
        RunsOf(rows, kGroup, "runs with a complete assembly",
               [](const json& row) {
                 return row.at("complete") && row.at("state") == "done";
               }),
        StopsOf(rows, StopKind::kProtective),
        StopsOf(rows, StopKind::kHold),
        StopsOf(rows, StopKind::kDeath),
        RunsOf(rows, kGroup, "runs in which nothing seated came loose again",
               [](const json& row) { return row.at("broken").empty(); }),
        RunsOf(rows, kGroup, "runs without a breach of limits", HasKeptLimits),
        RunsOf(rows, kGroup, "runs without a collision", HasHitNothing)};
  }

  /// How often each stage was stopped, and what moved most.
  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    std::map<std::string, int> num_of;
    double most = 0;
    for (const json& row : rows) {
      for (const json& stop : row.at("stops")) {
        const auto stage = stop.at("stage").get<std::string>();
        const bool is_way = stage.starts_with("go to ");
        ++num_of[stage.empty() ? "between skills" : is_way ? "go to" : stage];
        most = std::max(most, stop.at("moved_mm").get<double>());
      }
    }
    std::vector<Figure> figures = {
        {std::string(kGroup) + ": largest motion of a placed part", most,
         "mm"}};
    for (const auto& [stage, num] : num_of) {
      figures.push_back({std::string(kGroup) + ": stopped at '" + stage + "'",
                         static_cast<double>(num), "stops"});
    }
    return figures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeStopsEvaluation() {
  return std::make_unique<StopsEvaluation>();
}

}  // namespace cell::cli
