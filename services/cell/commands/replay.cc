#include "common/bus/replay.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "common/bus/live_log.h"
#include "common/bus/live_replay.h"
#include "common/node/cell_files.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/reporting/narrator.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/service_registry.h"

namespace cell::cli {
namespace {

struct ReplayOptions {
  std::string run;
  std::vector<std::string> services;
  bool is_check = false;
  bool is_verbose = false;
};

void Describe(const Message& message, Narrator* narrator) {
  for (const std::string& line : narrator->Describe(message)) {
    std::cout << line << "\n";
  }
}

// Recomputes the services in `names`, all if it is empty, and prints a line for
// each; `replay_of` returns that line, and whether the service replays.
template <class ReplayOf>
int CheckServices(const RunFolder& run, std::vector<std::string> names,
                  const ReplayOf& replay_of) {
  if (names.empty()) {
    for (const auto& entry : run.roster.entries) names.push_back(entry.name);
  }
  int num_different = 0;
  for (const std::string& name : names) {
    run.roster.RequireIndexOf(name);
    std::cout << fmt::format("{:20} ", name) << std::flush;
    const auto factories =
        AllServices(run.deployment, run.demonstration, run.seed);
    const auto [is_well, line] = replay_of(name, factories.at(name));
    if (!is_well) ++num_different;
    std::cout << Printable(line) << std::endl;
  }
  return num_different == 0 ? 0 : 1;
}

std::pair<bool, std::string> ReplayOne(const RunFolder& run, const RunLog& log,
                                       const std::string& name,
                                       const ServiceFactory& factory) {
  const ReplayResult result = Replay(log, run.roster, name, factory);
  if (result.difference) return {false, "DIFFERENT: " + *result.difference};
  if (result.num_messages == 0 && !result.gap_after) {
    return {true, "this log has no messages of it"};
  }
  std::string line =
      Counted(result.num_messages, "message") + ", byte-identical";
  if (result.gap_after) {
    line += fmt::format(" up to the gap after tick {}", *result.gap_after);
  }
  return {true, line};
}

std::pair<bool, std::string> ReplayOneLive(const RunFolder& run,
                                           const LiveLog& log,
                                           const std::string& name,
                                           const ServiceFactory& factory) {
  const LiveReplayResult result = ReplayLive(log, run.roster, name, factory);
  if (result.difference) return {false, "DIFFERENT: " + *result.difference};
  if (result.num_incarnations == 0)
    return {true, "this log has no journal of it"};
  std::string line = fmt::format("{} of {}, byte-identical",
                                 Counted(result.num_messages, "message"),
                                 Counted(result.num_incarnations, "start"));
  if (result.num_unrecorded > 0) {
    line += fmt::format("; {} more are missing from the log",
                        result.num_unrecorded);
  }
  for (const std::string& gap : result.gaps) line += "; up to " + gap;
  for (const std::string& skipped : result.skipped) {
    line += "; not replayed: " + skipped;
  }
  return {result.gaps.empty(), line};
}

// The first ones; all are counted.
void Report(const std::vector<std::string>& lines, const char* prefix) {
  constexpr size_t kMaxLines = 20;
  for (size_t i = 0; i < std::min(lines.size(), kMaxLines); ++i) {
    std::cerr << prefix << Printable(lines[i]) << "\n";
  }
  if (lines.size() <= kMaxLines) return;
  std::cerr << fmt::format("{}... and {} more\n", prefix,
                           lines.size() - kMaxLines);
}

int ReplayLiveRun(const ReplayOptions& options, RunFolder run) {
  run.deployment.has_operator = true;  // as it was recorded
  const LiveLog log = LiveLog::Load(options.run);
  const auto problems = log.Problems(run.roster);
  Report(problems, "log: ");
  if (!options.is_check) {
    Narrator narrator(options.is_verbose);
    for (const Message* message : log.InOrder()) Describe(*message, &narrator);
    return problems.empty() ? 0 : 1;
  }
  Report(log.LateMessages(run.roster), "late: ");
  const int result = CheckServices(
      run, options.services,
      [&](const std::string& name, const ServiceFactory& factory) {
        return ReplayOneLive(run, log, name, factory);
      });
  return problems.empty() ? result : 1;
}

// To narrate a recording its log is enough; recomputing needs a run folder.
RunFolder FolderOf(const ReplayOptions& options) {
  const std::filesystem::path path = options.run;
  const bool is_recording =
      LogsOf(path).empty() && !LoggerPartsOf(path).empty();
  if (!is_recording || std::filesystem::exists(path / "run.yaml")) {
    return RunFolder::Open(options.run);
  }
  if (options.is_check) {
    throw std::runtime_error(
        options.run +
        ": is a recording of lcm-logger, not a run folder: it lacks run.yaml "
        "and deploy/, which are needed to recompute services. Put its parts "
        "into a copy of the run folder, in place of its log; or replay it "
        "without --check");
  }
  RunFolder run;
  run.path = path;
  run.roster = FindCellFiles("").roster;
  return run;
}

int RunReplay(const ReplayOptions& options) {
  const RunFolder run = FolderOf(options);
  if (LiveLog::IsLive(RequireLogsOf(options.run))) {
    return ReplayLiveRun(options, run);
  }
  const RunLog log = RunLog::Load(options.run);
  for (const std::string& problem : log.problems()) {
    std::cerr << "log: " << Printable(problem) << "\n";
  }
  if (!options.is_check) {
    Narrator narrator(options.is_verbose);
    for (const auto& [k, tick] : log.ticks()) {
      for (const Message& message : tick.messages) Describe(message, &narrator);
    }
    return log.problems().empty() ? 0 : 1;
  }
  const int result = CheckServices(
      run, options.services,
      [&](const std::string& name, const ServiceFactory& factory) {
        return ReplayOne(run, log, name, factory);
      });
  return log.problems().empty() ? result : 1;
}

}  // namespace

void AddReplay(CLI::App& app, Action* action) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(
      "replay",
      "Print again what happened in a recorded run, or recompute every "
      "service's outputs from its recorded inputs.\nExample: cell replay "
      "runs/demo-0001 --check");
  command->add_option("run", options->run, "run folder")->required();
  CLI::Option* check = command->add_flag("--check", options->is_check,
                                         "recompute and compare byte for byte");
  command
      ->add_flag("--verbose", options->is_verbose,
                 "also print whole plans, and conditions as formulas")
      ->excludes(check);
  command
      ->add_option("--service", options->services,
                   "only this service (may be repeated)")
      ->needs(check);
  command->callback([=] {
    *action = [=] {
      return RunReplay(*options);
    };
  });
}

}  // namespace cell::cli
