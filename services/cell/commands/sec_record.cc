#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "common/recordings/recording_text.h"
#include "common/text/counted.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/recordings/run_recording.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

struct RecordingOptions {
  std::string run;
  std::string out;
  int episode = 1;
  int decimals = 5;
  bool is_exact = false;
};

int WriteRecording(const RecordingOptions& options) {
  RequireFree(options.out, kChooseAnotherOut);
  const Recording recording = RecordingOfRun(RunFolder::Open(options.run),
                                             options.episode, CELL_VERSION);
  const std::string text = RecordingToText(
      recording,
      options.is_exact ? std::nullopt : std::optional<int>(options.decimals));
  WriteNewFile(options.out, text, kChooseAnotherOut);
  std::cout << fmt::format(
      "{}: {} of {} in {} bytes\n", options.out,
      Counted(static_cast<int64_t>(recording.frames.size()), "frame"),
      Counted(static_cast<int64_t>(recording.bodies.size()), "body", "bodies"),
      text.size());
  return 0;
}

}  // namespace

void AddSecRecord(CLI::App& sec, Action* action) {
  auto options = std::make_shared<RecordingOptions>();
  CLI::App* command = sec.add_subcommand(
      "record",
      "Write the true poses of parts and hands of a simulated episode as a "
      "recording: text, to learn and to evaluate from without simulating "
      "again.\n"
      "Example: cell sec record runs/sim-0001 --out demonstration.recording");
  command->add_option("run", options->run, "run folder")->required();
  command->add_option("--out", options->out, "file to create")->required();
  command
      ->add_option("--episode", options->episode,
                   "number of the episode, from "
                   "1")
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  CLI::Option* decimals = command
                              ->add_option("--decimals", options->decimals,
                                           "decimal places of positions in m")
                              ->check(NumberIn(3, 12))
                              ->capture_default_str();
  command
      ->add_flag("--exact", options->is_exact,
                 "every number as it was measured: larger")
      ->excludes(decimals);
  command->callback([=] {
    *action = [=] {
      return WriteRecording(*options);
    };
  });
}

}  // namespace cell::cli
