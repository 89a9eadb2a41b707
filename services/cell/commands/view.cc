#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/bus/event_log.h"
#include "common/bus/run_log.h"
#include "common/files/draft.h"
#include "common/imaging/png_file.h"
#include "common/node/number_option.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/pictures/frame_picture.h"
#include "services/cell/pictures/scene_picture.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

constexpr char kFrame[] = "FRAME_";  // and the number of the camera set

struct ViewOptions {
  std::string run;
  std::string out = "scene.png";
  std::optional<double> at_s;
  std::string camera;
  bool is_of_depth = false;
  bool has_counts = false;
  Viewpoint viewpoint;
};

double Seconds(int64_t utime) {
  return static_cast<double>(utime) * 1e-6;
}

// The last message of the channel that was measured at or before the requested
// time.
template <BusMessage M>
M MessageAt(const RunFolder& run, const std::string& channel,
            std::optional<double> at_s) {
  std::optional<M> last;
  for (const auto& log : LogsOf(run.path)) {
    EventLogReader reader(log);
    reader.Finish();
    while (auto event = reader.Next()) {
      if (event->channel != channel) continue;
      const auto message =
          MessageFromWire(event->channel, std::move(event->bytes));
      auto decoded = message ? Decode<M>(*message) : std::nullopt;
      if (!decoded) continue;
      if (at_s && Seconds(decoded->header.utime) > *at_s && last) return *last;
      last = std::move(decoded);
    }
  }
  if (!last) {
    throw std::runtime_error(
        run.path.string() + ": the log holds no " + channel +
        (channel.starts_with(kFrame) ? "; only runs with --cameras have frames"
                                     : ""));
  }
  return *last;
}

int ViewScene(const RunFolder& run, const ViewOptions& options) {
  const auto poses = MessageAt<truth_poses_t>(run, "TRUTH_POSES", options.at_s);
  Draft draft(options.out);
  const auto num_pixels =
      DrawScene(run.deployment, poses, options.viewpoint, draft.path());
  draft.PutNew(kAnotherOut);
  if (options.has_counts) {
    for (const auto& [name, num] : num_pixels) {
      std::cout << fmt::format("{:24} {:7} pixels\n", Printable(name), num);
    }
  }
  std::cout << fmt::format("{} shows {:.2f} s\n", options.out,
                           Seconds(poses.header.utime));
  return 0;
}

int ViewFrame(const RunFolder& run, const ViewOptions& options) {
  const std::string channel = kFrame + options.camera;
  const auto message = MessageAt<rgbd_frame_t>(run, channel, options.at_s);
  const auto frame = FrameFromMessage(message);
  if (!frame) {
    throw std::runtime_error(fmt::format("{} at {:.2f} s cannot be decoded",
                                         channel,
                                         Seconds(message.header.utime)));
  }
  Draft draft(options.out);
  WritePng(draft.path(),
           options.is_of_depth ? GreyOfDepth(*frame) : frame->colour);
  draft.PutNew(kAnotherOut);
  std::cout << fmt::format("{} shows what camera {} saw at {:.2f} s\n",
                           options.out, options.camera, Seconds(frame->utime));
  return 0;
}

int RunView(const ViewOptions& options) {
  RequireFree(options.out, kAnotherOut);
  const RunFolder run = RunFolder::Open(options.run);
  return options.camera.empty() ? ViewScene(run, options)
                                : ViewFrame(run, options);
}

}  // namespace

void AddView(CLI::App& app, Action* action) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand(
      "view",
      "Draw a recorded run at any time, or show a frame of a camera.\n"
      "Example: cell view runs/demo-0001 --at 20 --out scene.png");
  command->add_option("run", options->run, "run folder")->required();
  command
      ->add_option("--at", options->at_s,
                   "[s] time to draw (default: the last)")
      ->check(NumberIn(0., 1e9));
  command->add_option("--out", options->out, "PNG file")->capture_default_str();
  command->add_flag("--ids", options->viewpoint.is_of_ids,
                    "give every body its own colour");
  command->add_flag("--labels", options->viewpoint.has_labels,
                    "write the name on each part");
  command->add_flag("--counts", options->has_counts,
                    "print how many pixels show each body");
  CLI::Option* camera = command->add_option(
      "--camera", options->camera, "show the frame of this camera set, e.g. 1");
  command
      ->add_flag("--depth", options->is_of_depth,
                 "show its depth as grey: near is bright")
      ->needs(camera);
  command
      ->add_option("--azimuth", options->viewpoint.azimuth_deg,
                   "[deg] of the camera about the vertical")
      ->check(NumberIn(-360., 360.))
      ->capture_default_str();
  command
      ->add_option("--elevation", options->viewpoint.elevation_deg,
                   "[deg] of the camera above the table")
      ->check(NumberIn(1.0, 89.0))
      ->capture_default_str();
  command
      ->add_option("--focus", options->viewpoint.focus,
                   "what fills the picture: cell, parts, or a name, e.g. "
                   "arm_left")
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return RunView(*options);
    };
  });
}

}  // namespace cell::cli
