#include "services/cell/evaluations/from_nothing_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/files/temporary_folder.h"
#include "common/task/task.h"
#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/evaluations/taught_episodes.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/run_options.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr char kGroup[] = "from_nothing";
constexpr size_t kNumEpisodes = 3;
constexpr size_t kAlone = 2;  // the first episode without a teacher
constexpr double kGoal = 0.9;

/// Of the messages and the arms of all episodes.
bool AllEpisodes(const json& row, bool (*holds)(const json&)) {
  return std::ranges::all_of(row.at("episodes"), holds);
}

double Number(const json& episode, const std::string& key) {
  const json& value = episode.at(key);
  return value.is_array() ? static_cast<double>(value.size())
                          : value.get<double>();
}

class FromNothingEvaluation final : public Evaluation {
 public:
  std::string name() const override { return kGroup; }
  std::string description() const override {
    return "Start without actions and rules, learn from a person who is asked, "
           "and assemble without questions in the third episode.";
  }
  int default_runs() const override { return 20; }

  /// The episodes of a run have consecutive seeds: no two runs share one.
  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const uint64_t seed = kNumEpisodes * trial.seed;
    const TemporaryFolder folder("from-nothing");
    const RunFolder run =
        RunFolder::Create((folder.path() / "run").string(), "eval", deployment,
                          kTaughtEpisodes, seed);
    run.LearnFromNothing();
    Deployment of_run = run.deployment;
    of_run.run_dir.clear();  // no log
    const Task task = LoadTask(of_run);
    const auto success = SuccessCriterion::FromConfig(
        of_run.OfTask("success.yaml"), task.domain, task.parts);
    TaughtEpisodes episodes(task, success);
    SimBus bus(roster, AllServices(of_run, kTaughtEpisodes, seed));
    RunToEnd(bus, [&](const Message& message) { episodes.Put(message); });
    const json rows = episodes.Rows();
    return {{"episodes", rows}, {"taught", IsTaughtFrom(rows, kAlone)}};
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    const RowShape episode = AssemblyRowShape().With(
        {{"questions", RowShape::ListOf(kText)}, {"demonstrations", kWhole}});
    return RowShape::Record(
        {{"taught", kFlag}, {"episodes", RowShape::ListOf(episode)}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures = {
        RunsOf(rows, kGroup, "assembled without a question in the third",
               [](const json& row) { return row.at("taught") == true; }),
        RunsOf(rows, kGroup, "all episodes assembled",
               [](const json& row) {
                 return AllEpisodes(row, [](const json& episode) {
                   return episode.at("complete") == true;
                 });
               }),
        RunsOf(rows, kGroup, "runs without a breach of limits",
               [](const json& row) { return AllEpisodes(row, HasKeptLimits); }),
        RunsOf(rows, kGroup, "runs without a collision", [](const json& row) {
          return AllEpisodes(row, HasHitNothing);
        })};
    measures.front().goal = kGoal;
    return measures;
  }

  /// Means of each episode.
  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    std::vector<Figure> figures;
    for (size_t i = 0; i < kNumEpisodes; ++i) {
      for (const char* key : {"questions", "demonstrations", "requests",
                              "failed", "placements_seated", "turned_home"}) {
        double sum = 0;
        int num = 0;
        for (const json& row : rows) {
          const json& episodes = row.at("episodes");
          if (episodes.size() <= i) continue;
          sum += Number(episodes[i], key);
          ++num;
        }
        figures.push_back(
            {fmt::format("{}: episode {}: {}", kGroup, i + 1, key),
             num > 0 ? sum / num : 0, "a run"});
      }
    }
    return figures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeFromNothingEvaluation() {
  return std::make_unique<FromNothingEvaluation>();
}

}  // namespace cell::cli
