#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/actions/sec_models.h"
#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/recordings/recording_file.h"
#include "common/recordings/recording_text.h"
#include "common/text/counted.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/learn_rules.h"
#include "services/cell/learning/sec_lessons.h"
#include "services/cell/learning/teaching.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kOtherRecordings[] = "choose another --recordings or remove it";
constexpr int kDecimals = 5;  // [m] a hundredth of a millimetre

struct LearnOptions {
  std::string deploy_dir;
  std::string recordings;
  std::string out;
  uint64_t seed = 1;
  bool is_simulated = false;
};

/// The scripts of demonstrators.yaml that teach, each with a seed of its own.
void Simulate(const LearnOptions& options, const Deployment& deployment,
              const fs::path& folder) {
  const auto demonstrations = vtb::Demonstrations::FromConfig(
      deployment.OfTask("demonstrators.yaml"), LoadTask(deployment).parts);
  if (demonstrations.teaching.empty()) {
    throw std::runtime_error(
        "demonstrators.yaml:teaching: names no script to learn from");
  }
  MakeFolder(folder);
  uint64_t seed = options.seed;
  for (const std::string& script : demonstrations.teaching) {
    const fs::path file =
        folder / fmt::format("{}-{}{}", script, seed, kRecordingExtension);
    RequireFree(file, kOtherRecordings);
    const Recording recording = Teach(deployment, script, seed++, CELL_VERSION);
    WriteNewFile(file, RecordingToText(recording, kDecimals), kOtherRecordings);
    std::cout << fmt::format(
        "{}: {}, {}\n", file.string(),
        Counted(static_cast<int64_t>(recording.frames.size()), "frame"),
        Counted(static_cast<int64_t>(recording.spoken.size()), "name"));
  }
}

int LearnSec(const LearnOptions& options) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  const fs::path folder = options.recordings.empty()
                              ? deployment.task_dir / kRecordingsFolder
                              : fs::path(options.recordings);
  if (!options.out.empty()) RequireFree(options.out, kAnotherOut);
  if (options.is_simulated) Simulate(options, deployment, folder);
  const std::vector<fs::path> files = RecordingsIn(folder);
  if (files.empty()) {
    throw std::runtime_error(folder.string() + ": has no file *" +
                             kRecordingExtension + "; --simulate makes them");
  }
  SecLessons lessons(deployment);
  for (const fs::path& file : files) {
    lessons.Attend(LoadRecording(file));
  }
  for (const SecLearner::Action& action : lessons.Actions()) {
    std::cout << fmt::format(
        "{}: {}{}\n", action.name,
        Counted(int64_t{action.model.NumShown()}, "showing"),
        action.is_named ? "" : ", not named: left out");
  }
  const std::string text = lessons.ModelsText();
  if (options.out.empty()) {
    std::cout << text;
  } else {
    WriteNewFile(options.out, text, kAnotherOut);
  }
  return 0;
}

}  // namespace

void AddLearn(CLI::App& app, Action* action) {
  CLI::App* learn =
      app.add_subcommand("learn",
                         "Learn from recorded demonstrations and runs.\n"
                         "Example: cell learn sec --out sec_models.yaml");
  learn->require_subcommand(1);
  AddLearnRules(*learn, action);
  auto options = std::make_shared<LearnOptions>();
  CLI::App* sec = learn->add_subcommand(
      "sec",
      "Learn how the task's actions show in event chains, from its recordings, "
      "or from demonstrations that are simulated now.\n"
      "Example: cell learn sec --simulate --recordings shown --out "
      "sec_models.yaml");
  sec->add_option("--deploy", options->deploy_dir,
                  "folder with config/ and tasks/");
  sec->add_option("--recordings", options->recordings,
                  "folder of *.recording (default: recordings/ of the task)");
  sec->add_option("--out", options->out,
                  "file to create (default: print the models)");
  sec->add_flag("--simulate", options->is_simulated,
                "first simulate the scripts of `teaching` in "
                "demonstrators.yaml, and record them");
  sec->add_option("--seed", options->seed,
                  "of the first simulated demonstration")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  sec->callback([=] {
    *action = [=] {
      return LearnSec(*options);
    };
  });
}

}  // namespace cell::cli
