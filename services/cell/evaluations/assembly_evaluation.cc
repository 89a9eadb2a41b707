#include "services/cell/evaluations/assembly_evaluation.h"

#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kGroup[] = "assembly";

class AssemblyEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "assembly"; }
  std::string description() const override {
    return "Let the arms assemble everything: seated parts, limits, "
           "collisions.";
  }
  int default_runs() const override { return 40; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    return RunAssembly(kExecutionScript, trial.seed, deployment, roster);
  }

  RowShape row_shape() const override { return AssemblyRowShape(); }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures = {
        RunsOf(rows, kGroup, "runs with all placements seated",
               [](const json& row) {
                 return row.at("placements_seated") == row.at("placements");
               }),
        ShareOf(rows, kGroup, "placements seated", "placements_seated",
                "placements"),
        ShareOf(rows, kGroup, "threaded parts tightened", "turned_home",
                "turned"),
        RunsOf(rows, kGroup, "runs in which nothing seated came loose again",
               [](const json& row) { return row.at("broken").empty(); }),
        RunsOf(rows, kGroup, "runs without a breach of limits", HasKeptLimits),
        RunsOf(rows, kGroup, "runs without a collision", HasHitNothing),
    };
    measures.front().paper = 0.5;
    return measures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeAssemblyEvaluation() {
  return std::make_unique<AssemblyEvaluation>();
}

}  // namespace cell::cli
