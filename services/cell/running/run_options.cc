#include "services/cell/running/run_options.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "services/cell/running/task_check.h"
#include "services/cell/running/task_variant.h"

namespace cell::cli {

void RunOptions::AddTo(CLI::App& command) {
  command.add_option("--deploy", deploy_dir, "folder with config/ and tasks/");
  command.add_option("--demonstration", demonstration,
                     "script of the task's demonstrators.yaml");
  command.add_option("--seed", seed, "seed of all random numbers")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  command.add_option("--out", out, "run folder (default: runs/...)");
  command
      .add_option("--help-steps", help_steps,
                  "robot actions that are left to the person, named as in the "
                  "task's domain")
      ->delimiter(',');
  command.add_flag("--cameras", has_cameras,
                   "run the camera sets and log their frames");
  CLI::Option* from_nothing = command.add_flag(
      "--from-nothing", is_from_nothing,
      "know no action at first but the arms' own skills, and learn how they "
      "look and what they do from what is shown and tried (default: three "
      "episodes with a person who shows what the cell asks for; implies "
      "--learn and --confirmed)");
  CLI::Option* learn = command.add_flag(
      "--learn", learns,
      "learn how actions look, and what they need and do, from what is shown "
      "and tried (default: learning: in recognizer.yaml and planner.yaml)");
  command.add_flag("--no-learn", does_not_learn, "learn nothing")
      ->excludes(learn)
      ->excludes(from_nothing);
  command.add_flag("--confirmed", is_confirmed,
                   "let arms do learned actions without an operator's "
                   "confirmation (default: exploration: in planner.yaml)");
  command.add_option("--library", library,
                     "library that the run works on and that outlives it "
                     "(default: library.db of the run folder)");
  command.add_option("--variant", variant,
                     "change the task as its variants/NAME.yaml says");
  command.add_flag("--hash", is_hash, "print only one digest per channel");
  command.add_flag("--verbose", is_verbose,
                   "also print whole plans, and conditions as formulas");
}

RunFolder RunOptions::CreateFolder(const std::string& kind) const {
  CellFiles files = FindCellFiles(deploy_dir);
  std::optional<VariedTask> varied;
  if (!variant.empty()) {
    files.deployment = varied.emplace(files.deployment, variant).deployment();
  }
  std::string episodes = demonstration;
  if (!help_steps.empty() && episodes.empty()) {
    episodes = "assembly+execution_helped";
  }
  if (is_from_nothing && episodes.empty()) episodes = kTaughtEpisodes;
  CheckTask(files, {.demonstration = episodes,
                    .has_cameras = has_cameras,
                    .help_steps = help_steps});
  RunFolder run =
      RunFolder::Create(out, kind, files.deployment, episodes, seed);
  if (!help_steps.empty()) run.LeaveToPerson(help_steps);
  if (is_from_nothing) run.LearnFromNothing();
  if (learns || does_not_learn) run.SetLearning(learns);
  if (is_confirmed) run.DoWithoutConfirmation();
  if (!library.empty()) {
    try {
      run.UseLibrary(library);
    } catch (...) {
      run.Discard();
      throw;
    }
  }
  if (has_cameras) run.EnableServices("cameras");
  return run;
}

}  // namespace cell::cli
