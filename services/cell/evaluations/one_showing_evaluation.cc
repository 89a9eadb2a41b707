#include "services/cell/evaluations/one_showing_evaluation.h"

#include <array>
#include <utility>

#include "common/actions/sec_models.h"
#include "common/recordings/recording_file.h"
#include "common/sec/learned_library.h"
#include "common/task/task.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/evaluations/stream_score.h"
#include "services/cell/learning/sec_lessons.h"
#include "services/cell/recordings/simulated_recording.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 2> kFurtherScripts = {"assembly",
                                                        "assembly_two_hands"};

std::shared_ptr<const SecLibrary> LibraryOfOneShowing(
    const Deployment& deployment, const Task& task) {
  SecLessons lessons(deployment);
  for (const auto& file :
       RecordingsIn(deployment.task_dir / kRecordingsFolder)) {
    lessons.AttendFirstShowings(LoadRecording(file));
  }
  std::vector<LearnedLibrary::Entry> entries;
  for (auto& [action, model] : lessons.Models()) {
    entries.push_back({action, std::move(model)});
  }
  return std::make_shared<const LearnedLibrary>(
      std::move(entries), std::make_shared<const SceneWords>(SceneWords{
                              task.domain.vocabulary(), task.parts}));
}

class OneShowingEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "one_showing"; }
  std::string description() const override {
    return "Recognise further assemblies after a single showing of each "
           "action.";
  }
  int default_runs() const override { return 50; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const Task task = LoadTask(deployment);
    const char* script = kFurtherScripts[trial.seed % kFurtherScripts.size()];
    ShownStreamParams params;
    params.library = LibraryOfOneShowing(deployment, task);
    params.demonstrations = {{script, [&] {
                                return SimulatedRecording(
                                    deployment, roster, script, trial.seed, "");
                              }}};
    const auto names =
        PlacementNames(vtb::Demonstrations::FromConfig(
                           deployment.OfTask("demonstrators.yaml"), task.parts),
                       task.parts);
    const StreamScore score =
        Score(ShowStream(params, deployment, task, [](const auto&) {}), names);
    return {{"script", script},
            {"steps", score.num_actions},
            {"recognised", score.num_actions_right},
            {"named", score.num_named},
            {"errors", score.errors}};
  }

  RowShape row_shape() const override {
    return RowShape::Counts({"steps", "recognised", "named"});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    Measure steps =
        ShareOf(rows, name(), "steps recognised", "recognised", "steps");
    steps.goal = 0.95;
    Measure right = ShareOf(rows, name(), "recognised actions that were done",
                            "recognised", "named");
    right.goal = 0.95;
    return {steps, right};
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeOneShowingEvaluation() {
  return std::make_unique<OneShowingEvaluation>();
}

}  // namespace cell::cli
