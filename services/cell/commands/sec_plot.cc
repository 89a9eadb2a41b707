#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell/episode_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/run_log.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/scene/key_frame.h"
#include "common/task/task.h"
#include "common/text/counted.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/commands/sec_plot_library.h"
#include "services/cell/pictures/chain_figure.h"
#include "services/cell/pictures/figure_file.h"
#include "services/cell/pictures/scene_picture.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

constexpr size_t kMaxColumns = 60;

struct PlotOptions {
  std::string log;
  std::string deploy_dir;
  std::string out;
  std::string object;
  std::string database;
  bool is_of_library = false;
  int episode = 1;
  bool has_no_pictures = false;
};

/// The key frames of an episode, and the poses of the testbed by utime.
struct ShownEpisode {
  std::vector<KeyFrame> frames;
  std::map<int64_t, truth_poses_t> poses;
};

/// Takes the messages of a log in their order.
class ShownEpisodeReader {
 public:
  ShownEpisodeReader(const SceneObjects& scene_objects, int number)
      : scene_objects_(scene_objects), number_(number) {}

  void Put(const Message& message) {
    if (message.channel == "EPISODE") {
      const auto m = Decode<episode_t>(message);
      num_started_ += m && m->phase == episode_t::START;
    }
    if (num_started_ != number_) return;
    if (message.channel == "KEY_FRAME") {
      const auto m = Decode<key_frame_t>(message);
      auto frame = m ? KeyFrameFromMessage(*m, scene_objects_) : std::nullopt;
      if (frame) episode_.frames.push_back(*std::move(frame));
    } else if (message.channel == "TRUTH_POSES") {
      if (auto m = Decode<truth_poses_t>(message)) {
        episode_.poses[m->header.utime] = *std::move(m);
      }
    }
  }

  const ShownEpisode& episode() const { return episode_; }

 private:
  const SceneObjects& scene_objects_;
  int number_;
  int num_started_ = 0;
  ShownEpisode episode_;
};

bool IsLogFile(const PlotOptions& options) {
  return std::filesystem::is_regular_file(options.log);
}

Deployment DeploymentOf(const PlotOptions& options) {
  return IsLogFile(options) ? FindCellFiles(options.deploy_dir).deployment
                            : RunFolder::Open(options.log).deployment;
}

/// @throws std::runtime_error naming the log if it has no key frames.
ShownEpisode ReadEpisode(const PlotOptions& options, const Task& task) {
  const RunLog log =
      IsLogFile(options)
          ? RunLog::Load(std::vector<std::filesystem::path>{options.log})
          : RunLog::Load(std::filesystem::path(options.log));
  ShownEpisodeReader reader(task.scene_objects, options.episode);
  for (const auto& [tick, entry] : log.ticks()) {
    for (const Message& message : entry.messages) reader.Put(message);
  }
  if (reader.episode().frames.empty()) {
    throw std::runtime_error(
        fmt::format("{}: the log has no KEY_FRAME of "
                    "episode {} that this build can read",
                    options.log, options.episode));
  }
  return reader.episode();
}

/// The rows that change, of the object if one is asked for, and the key frames
/// at which they do.
ChainFigure FigureOf(const ShownEpisode& episode, const PlotOptions& options,
                     std::vector<KeyFrame>* frames) {
  EventChain all = ChainOf(episode.frames);
  if (!options.object.empty()) all = all.RowsOf(options.object);
  if (all.num_rows() == 0) {
    throw std::invalid_argument(
        "--object " + options.object +
        ": no part, hand, segment or table has this name");
  }
  all = all.ChangingRows();
  ChainFigure figure;
  figure.chain = all.DistinctColumns();
  for (size_t i = 0; i < all.num_columns(); ++i) {
    const bool is_new =
        i == 0 || all.Slice(i - 1, i + 1).DistinctColumns().num_columns() == 2;
    if (!is_new) continue;
    const KeyFrame& frame = episode.frames[i];
    frames->push_back(frame);
    figure.titles.push_back(fmt::format(
        "{}: {:.2f} s", frame.index, static_cast<double>(frame.utime) * 1e-6));
  }
  if (figure.chain.num_rows() == 0) {
    throw std::invalid_argument(
        "no relation changes: there is nothing to draw");
  }
  if (figure.chain.num_columns() > kMaxColumns) {
    throw std::invalid_argument(
        fmt::format("{} key frames are too many for a picture, at most {}: "
                    "choose an --object",
                    figure.chain.num_columns(), kMaxColumns));
  }
  return figure;
}

void AddPictures(const ShownEpisode& episode,
                 const std::vector<KeyFrame>& frames, const Task& task,
                 ChainFigure* figure) {
  if (episode.poses.empty()) return;
  Viewpoint viewpoint;
  viewpoint.focus = "parts";
  viewpoint.width = 320;
  viewpoint.height = 240;
  for (const KeyFrame& frame : frames) {
    auto poses = episode.poses.upper_bound(frame.utime);
    if (poses != episode.poses.begin()) --poses;
    figure->pictures.push_back(PictureOf(task, poses->second, viewpoint).image);
  }
}

int Plot(const PlotOptions& options) {
  const FigureFile file{options.out, kChooseAnotherOut};
  file.Require();
  const Task task = LoadTask(DeploymentOf(options));
  const ShownEpisode episode = ReadEpisode(options, task);
  std::vector<KeyFrame> frames;
  ChainFigure figure = FigureOf(episode, options, &frames);
  if (!options.has_no_pictures) AddPictures(episode, frames, task, &figure);
  file.Write(SizeOf(figure),
             [&](Canvas* canvas) { DrawChain(figure, canvas); });
  std::cout << fmt::format(
      "{} shows {} and {}\n", options.out,
      Counted(static_cast<int64_t>(figure.chain.num_columns()), "key frame"),
      Counted(static_cast<int64_t>(figure.chain.num_rows()), "object pair"));
  return 0;
}

}  // namespace

void AddSecPlot(CLI::App& sec, Action* action) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = sec.add_subcommand(
      "plot",
      "Draw the event chain of an episode: each key frame as a picture and as "
      "a graph of what touches, and below them the matrix: 0 not touching, 1 "
      "touching, 2 overlapping, 9 absent. Or draw a library of models.\n"
      "Example: cell sec plot runs/sim-0001 --object bolt_1 --out bolt.svg");
  CLI::Option* log =
      command->add_option("log", options->log, "run folder, or a log");
  command->add_option("--out", options->out,
                      "PNG or SVG file (default: chain.png, library.png)");
  CLI::Option* library =
      command
          ->add_flag("--library", options->is_of_library,
                     "instead the models that were learned: their chains, the "
                     "demonstrations that are their members, and how alike "
                     "models and members are")
          ->excludes(log);
  command
      ->add_option("--database", options->database,
                   "of --library: a library's file, or a run folder that has "
                   "one (default: the models that the task comes with)")
      ->needs(library);
  command->add_option("--object", options->object,
                      "only rows of this part or hand");
  command
      ->add_option("--episode", options->episode,
                   "number of the episode, from 1")
      ->check(NumberIn(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--no-pictures", options->has_no_pictures,
                    "only graphs and matrix: smaller");
  command->add_option("--deploy", options->deploy_dir,
                      "of a log: folder with config/ and tasks/");
  command->callback([=] {
    if (options->is_of_library) {
      *action = [=] {
        return PlotLibrary(
            {options->database, options->deploy_dir,
             options->out.empty() ? "library.png" : options->out});
      };
      return;
    }
    if (options->log.empty()) throw CLI::RequiredError("log or --library");
    if (options->out.empty()) options->out = "chain.png";
    *action = [=] {
      return Plot(*options);
    };
  });
}

}  // namespace cell::cli
