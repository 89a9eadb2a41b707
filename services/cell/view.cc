#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "common/bus/event_log.h"
#include "common/bus/run_log.h"
#include "services/cell/commands.h"
#include "services/cell/episode_observer.h"
#include "services/cell/run_folder.h"
#include "services/cell/scene_picture.h"

namespace cell {
namespace {

struct ViewOptions {
  std::string run;
  std::string out = "scene.png";
  std::optional<double> at_s;
  Viewpoint viewpoint;
};

// The last poses at or before the wished moment.
truth_poses_t PosesAt(const std::vector<std::filesystem::path>& logs,
                      std::optional<double> at_s) {
  std::optional<truth_poses_t> poses;
  for (const auto& log : logs) {
    EventLogReader reader(log);
    reader.Finish();
    while (auto event = reader.Next()) {
      if (event->channel != "TRUTH_POSES") continue;
      const auto message =
          MessageFromWire(event->channel, std::move(event->bytes));
      auto decoded = message ? Decode<truth_poses_t>(*message) : std::nullopt;
      if (!decoded) continue;
      const double time_s = static_cast<double>(decoded->header.utime) * 1e-6;
      if (at_s && time_s > *at_s && poses) return *poses;
      poses = std::move(decoded);
    }
  }
  if (!poses) throw std::runtime_error("the log holds no TRUTH_POSES");
  return *poses;
}

int RunView(const ViewOptions& options) {
  const RunFolder run = RunFolder::Open(options.run);
  const truth_poses_t poses = PosesAt(LogsOf(run.path), options.at_s);
  const auto num_pixels =
      DrawScene(run.deployment, poses, options.viewpoint, options.out);
  for (const auto& [name, num] : num_pixels) {
    std::cout << fmt::format("{:24} {:7} pixels\n", name, num);
  }
  std::cout << fmt::format("{} shows {:.2f} s\n", options.out,
                           static_cast<double>(poses.header.utime) * 1e-6);
  return 0;
}

}  // namespace

void AddView(CLI::App& app, Action* action) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand(
      "view",
      "Draw any moment of a recorded run, and count each body's pixels.\n"
      "Example: cell view runs/demo-0001 --at 20 --out scene.png");
  command->add_option("run", options->run, "run folder")->required();
  command->add_option("--at", options->at_s, "[s] moment (default: the last)");
  command->add_option("--out", options->out, "PNG file")->capture_default_str();
  command->add_flag("--ids", options->viewpoint.is_of_ids,
                    "every body in a colour of its own");
  command
      ->add_option("--azimuth", options->viewpoint.azimuth_deg,
                   "[deg] of the camera about the vertical")
      ->capture_default_str();
  command
      ->add_option("--elevation", options->viewpoint.elevation_deg,
                   "[deg] of the camera above the table")
      ->check(CLI::Range(1.0, 89.0))
      ->capture_default_str();
  command
      ->add_option("--distance", options->viewpoint.distance,
                   "[m] of the camera")
      ->check(CLI::Range(0.1, 10.0))
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return RunView(*options);
    };
  });
}

}  // namespace cell
