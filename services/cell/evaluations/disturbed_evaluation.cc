#include "services/cell/evaluations/disturbed_evaluation.h"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/task/task.h"
#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/scoring/true_progress.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kSolvable[] = "solvable", kUnsolvable[] = "unsolvable";
constexpr double kUnsolvableShare = 0.25;  // of the number of solvable runs

// Scripts of the task's demonstrators.yaml, taken in turn.
const std::vector<std::string>& ScriptsOf(const std::string& group) {
  static const std::vector<std::string> solvable = {
      "execution_moved", "execution_returned", "execution_placed",
      "execution_to_the_left"};
  static const std::vector<std::string> unsolvable = {"execution_out_of_reach",
                                                      "execution_taken"};
  return group == kSolvable ? solvable : unsolvable;
}

bool IsDisturbed(const json& row) {
  return !row.at("touched").empty();
}

bool IsWhole(const json& row) {
  return row.at("complete") && row.at("state") == "done";
}

/// All that does not need what a person has taken away is in place, and nothing
/// that has to wait for it.
bool IsAllElsePlaced(const json& row, const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  std::map<std::string, int> empty;
  for (const auto& name : row.at("missing").get<std::vector<std::string>>()) {
    const Site* site = task.parts.FindSite(name);
    if (site != nullptr) ++empty[site->type];
  }
  return empty == EmptySitesWithout(
                      row.at("touched").get<std::set<std::string>>(),
                      vtb::Demonstrations::FromConfig(
                          deployment.OfTask("demonstrators.yaml"), task.parts),
                      task.parts);
}

bool AsksForWhatIsMissing(const json& row) {
  return row.at("state") == "stuck" && row.at("named") == row.at("touched");
}

class DisturbedEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "disturbed"; }
  std::string description() const override {
    return "Let the arms assemble while a person moves, takes and places "
           "parts.";
  }
  int default_runs() const override { return 24; }

  std::vector<TrialGroup> groups() const override {
    return {{kSolvable}, {kUnsolvable, kUnsolvableShare, 2}};
  }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const auto& scripts = ScriptsOf(trial.group);
    const std::string& script = scripts[trial.seed % scripts.size()];
    json row = RunAssembly(script, trial.seed, deployment, roster);
    row["script"] = script;
    row["all_else_placed"] = IsAllElsePlaced(row, deployment);
    return row;
  }

  RowShape row_shape() const override {
    return AssemblyRowShape().With({{"all_else_placed", RowShape::kFlag}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures = {
        RunsOf(rows, kSolvable, "runs in which a person interfered",
               IsDisturbed),
        RunsOf(rows, kSolvable, "runs with a complete assembly", IsWhole),
        RunsOf(rows, kUnsolvable, "runs in which a person interfered",
               IsDisturbed),
        RunsOf(rows, kUnsolvable,
               "runs that end by asking for exactly the missing part",
               AsksForWhatIsMissing),
        RunsOf(rows, kUnsolvable,
               "runs in which before that all else is placed",
               [](const json& row) {
                 return AsksForWhatIsMissing(row) && row.at("all_else_placed");
               })};
    for (const char* group : {kSolvable, kUnsolvable}) {
      measures.push_back(RunsOf(rows, group, "runs without a breach of limits",
                                HasKeptLimits));
      measures.push_back(
          RunsOf(rows, group, "runs without a collision", HasHitNothing));
    }
    return measures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeDisturbedEvaluation() {
  return std::make_unique<DisturbedEvaluation>();
}

}  // namespace cell::cli
