#include "services/cell/commands/rules_record.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/experiences/experience_text.h"
#include "common/files/draft.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/text/counted.h"
#include "services/cell/commands/library_commands.h"
#include "services/cell/learning/library_experiences.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/running/progress.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxCount = 1'000;

struct RecordOptions {
  std::vector<std::string> runs;
  std::vector<std::string> scripts;
  std::string library;
  std::string deploy_dir;
  uint64_t seed = 1;
  int count = 1;
  std::string out;
};

/// The text of all experiences, and how many there are of each action.
class ExperienceWriter {
 public:
  void Add(const std::string& script, uint64_t seed,
           const std::vector<rules::Experience>& experiences,
           const RuleWorld& world) {
    Add(fmt::format("{}, seed {}", script, seed), experiences, world);
  }
  void Add(const std::string& source,
           const std::vector<rules::Experience>& experiences,
           const RuleWorld& world) {
    for (const rules::Experience& experience : experiences) {
      Counts& counts =
          counts_[world.world()->symbols()[experience.act.action].name];
      ++counts.all;
      counts.unchanged += experience.before == experience.after;
    }
    text_ += "# " + source + "\n" + ToText(experiences, world);
  }

  void Write(const std::string& out) const {
    if (counts_.empty()) {
      throw std::runtime_error("nothing was experienced; " + out +
                               " is not written");
    }
    WriteNewFile(out, text_, kAnotherOut);
    for (const auto& [action, counts] : counts_) {
      std::cout << fmt::format("{}: {}, {} without a change\n", action,
                               Counted(counts.all, "experience"),
                               counts.unchanged);
    }
    std::cout << fmt::format("{}: {} bytes\n", out, text_.size());
  }

 private:
  struct Counts {
    int64_t all = 0;
    int64_t unchanged = 0;
  };
  std::string text_;
  std::map<std::string, Counts> counts_;
};

void Simulate(const RecordOptions& options, ExperienceWriter* writer) {
  const CellFiles files = FindCellFiles(options.deploy_dir);
  const RuleWorld world = RuleWorldOf(LoadTask(files.deployment).domain);
  Progress progress;
  for (const std::string& script : options.scripts) {
    for (int i = 0; i < options.count; ++i) {
      progress.Show(
          fmt::format("{}, run {} of {}", script, i + 1, options.count));
      const uint64_t seed = options.seed + static_cast<uint64_t>(i);
      writer->Add(script, seed,
                  ExperiencesOfSimulation(files.deployment, files.roster,
                                          script, seed, world),
                  world);
    }
  }
}

void AddOfLibrary(const RecordOptions& options, ExperienceWriter* writer) {
  const Deployment deployment = FindCellFiles(options.deploy_dir).deployment;
  const LibraryExperiences all = ReadLibraryExperiences(
      LibraryFile(options.library),
      LoadTask(deployment, LearnedRules::kLeaveOut).domain);
  PrintLeftOut(all);
  writer->Add("library " + fs::path(options.library).filename().string(),
              all.experiences, all.world);
}

int RecordExperiences(const RecordOptions& options) {
  RequireFree(options.out, kAnotherOut);
  if (options.runs.empty() && options.scripts.empty() &&
      options.library.empty()) {
    throw std::runtime_error(
        "nothing to record: name run folders or a --library, or --simulate a "
        "demonstration");
  }
  ExperienceWriter writer;
  for (const std::string& path : options.runs) {
    const RunFolder run = RunFolder::Open(path);
    const RuleWorld world = RuleWorldOf(LoadTask(run.deployment).domain);
    writer.Add(run.demonstration, run.seed, ExperiencesOfRun(run, world),
               world);
  }
  if (!options.library.empty()) AddOfLibrary(options, &writer);
  if (!options.scripts.empty()) Simulate(options, &writer);
  writer.Write(options.out);
  return 0;
}

}  // namespace

void AddRulesRecord(CLI::App& rules, Action* action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = rules.add_subcommand(
      "record",
      "Write the experiences of runs as text, to learn rules from: the state "
      "as sensed before and after each recognised action, each skill that "
      "failed, and each attempt that a person says has failed; or those that "
      "a library has kept.\n"
      "Example: cell rules record --simulate attempts --seed 901 --count 24 "
      "--out attempts.experiences");
  command->add_option("runs", options->runs, "run folders");
  command->add_option("--simulate", options->scripts,
                      "simulate runs of these demonstrations, without logs");
  command->add_option("--library", options->library,
                      "a library's file, or a run folder that has one: all "
                      "that it has experienced of the actions that it knows");
  command
      ->add_option("--seed", options->seed,
                   "of the first simulated run; the next has the next")
      ->check(NumberIn<uint64_t>(0, UINT64_MAX - kMaxCount))
      ->capture_default_str();
  command
      ->add_option("--count", options->count,
                   "number of simulated runs of each demonstration")
      ->check(NumberIn(1, kMaxCount))
      ->capture_default_str();
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/, to simulate, or of the "
                      "library's task");
  command->add_option("--out", options->out, "file to create")->required();
  command->callback([=] {
    *action = [=] {
      return RecordExperiences(*options);
    };
  });
}

}  // namespace cell::cli
