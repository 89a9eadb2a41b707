#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "common/bus/live_state.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/task_check.h"

namespace cell::cli {
namespace {

// [s since 1970] Its microseconds fit into a utime.
constexpr int64_t kLatestStart =
    std::numeric_limits<int64_t>::max() / 1'000'000;

struct PrepareOptions {
  std::string deploy_dir;
  std::string state_dir;
  std::string demonstration;
  uint64_t seed = 1;
  bool has_cameras = false;
  std::optional<int64_t> start_s;  // UTC
};

// [us of the monotonic clock]
int64_t MonotonicTimeOf(int64_t utc_s) {
  using std::chrono::microseconds;
  constexpr int64_t kSecond = 1'000'000;
  const auto now = [](auto clock) {
    return std::chrono::duration_cast<microseconds>(
               decltype(clock)::now().time_since_epoch())
        .count();
  };
  const int64_t utc = now(std::chrono::system_clock());
  if (utc_s > utc / kSecond) {
    throw std::invalid_argument(fmt::format(
        "--start {}: is in the future by this host's clock", utc_s));
  }
  return now(std::chrono::steady_clock()) - (utc - utc_s * kSecond);
}

int Prepare(const PrepareOptions& options) {
  const CellFiles files = FindCellFiles(options.deploy_dir);
  CheckTask(files, {.demonstration = options.demonstration,
                    .has_cameras = options.has_cameras});
  const LiveState state(options.state_dir);
  options.start_s ? state.CountFrom(MonotonicTimeOf(*options.start_s))
                  : state.Forget();
  const std::filesystem::path runs =
      std::filesystem::path(options.state_dir) / "runs";
  RunFolder run =
      RunFolder::Create(ClaimRunFolder(runs, "live").string(), "live",
                        files.deployment, options.demonstration, options.seed);
  if (options.has_cameras) run.EnableServices("cameras");
  PointTo(run.path, runs / "current");
  std::cout << "the session is recorded in " << run.path.string() << "\n";
  return 0;
}

}  // namespace

void AddPrepare(CLI::App& app, Action* action) {
  auto options = std::make_shared<PrepareOptions>();
  CLI::App* command = app.add_subcommand(
      "prepare",
      "Prepare a session of a live cell that is not running yet: ticks start "
      "at 0, and its logs go to a new folder, STATE_DIR/runs/current. `cell "
      "up` does this itself."
      "\nExample: cell prepare --state-dir /var/lib/cell --seed 7");
  command
      ->add_option("--state-dir", options->state_dir,
                   "state folder of the live cell")
      ->required();
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--demonstration", options->demonstration,
                      "script that the testbed begins with");
  command->add_option("--seed", options->seed, "seed of its random numbers")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  command->add_flag("--cameras", options->has_cameras, "run the camera sets");
  command
      ->add_option("--start", options->start_s,
                   "when ticks begin [s since 1970, UTC]: the same on all "
                   "hosts of a cell (default: when the first service starts)")
      ->check(NumberIn<int64_t>(0, kLatestStart));
  command->callback([=] {
    *action = [=] {
      return Prepare(*options);
    };
  });
}

}  // namespace cell::cli
