#include "services/cell/recordings/run_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cell/command_name_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/tracks_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/run_log.h"
#include "common/task/task.h"

namespace cell::cli {
namespace {

/// Parts, and the boxes of hands.
std::vector<std::string> BodiesOf(const Task& task) {
  std::vector<std::string> bodies = task.scene_objects.parts();
  for (const CellLayout::NamedHand& hand : task.layout.AllHands()) {
    for (const HandType::Box& box : hand.type->boxes) {
      bodies.push_back(hand.name + "." + box.name);
    }
  }
  std::ranges::sort(bodies);
  return bodies;
}

/// Takes the messages of a log in their order.
class EpisodeRecorder {
 public:
  EpisodeRecorder(Recording head, int number)
      : recording_(std::move(head)), number_(number) {
    for (size_t i = 0; i < recording_.bodies.size(); ++i) {
      index_[recording_.bodies[i]] = i;
    }
  }

  void Put(const Message& message) {
    if (message.channel == "EPISODE") {
      if (const auto m = Decode<episode_t>(message)) OnEpisode(*m);
    } else if (message.channel == "TRUTH_POSES") {
      if (auto m = Decode<truth_poses_t>(message)) {
        truths_[m->header.utime] = *std::move(m);
      }
    } else if (message.channel == "TRACKS" && num_started_ == number_) {
      if (const auto m = Decode<tracks_t>(message)) OnTracks(m->header.utime);
    } else if (message.channel == "COMMAND_NAME" && num_started_ == number_) {
      if (const auto m = Decode<command_name_t>(message)) {
        recording_.spoken.push_back(
            {int64_t{message.tick} * kTickUs, m->name, m->is_undone != 0});
      }
    }
  }

  bool has_episode() const { return num_started_ >= number_; }
  const Recording& recording() const { return recording_; }

 private:
  void OnEpisode(const episode_t& message) {
    if (message.phase != episode_t::START) return;
    if (++num_started_ != number_) return;
    start_utime_ = message.header.utime;
    recording_.task = message.task;
    recording_.demonstration = message.demonstration;
    recording_.seed = static_cast<uint64_t>(message.seed);
  }

  void OnTracks(int64_t utime) {
    auto truth = truths_.upper_bound(utime);
    if (utime < start_utime_ || truth == truths_.begin()) return;
    --truth;
    auto& frames = recording_.frames;
    if (!frames.empty() && utime <= frames.back().utime) return;
    Recording::Frame& frame = frames.emplace_back();
    frame.utime = utime;
    frame.poses.resize(recording_.bodies.size());
    for (const body_pose_t& body : truth->second.bodies) {
      const auto index = index_.find(body.name);
      if (index == index_.end()) continue;
      frame.poses[index->second] = body.pose_world_body;
    }
    truths_.erase(truths_.begin(), truth);
  }

  Recording recording_;
  int number_;
  int num_started_ = 0;
  int64_t start_utime_ = 0;
  std::map<std::string, size_t> index_;
  std::map<int64_t, truth_poses_t> truths_;  // by utime; older ones are dropped
};

}  // namespace

Recording RecordingOfRun(const RunFolder& run, int number,
                         const std::string& build) {
  Recording head;
  head.bodies = BodiesOf(LoadTask(run.deployment));
  head.build = build;
  EpisodeRecorder recorder(std::move(head), number);
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [tick, entry] : log.ticks()) {
    for (const Message& message : entry.messages) recorder.Put(message);
  }
  if (!recorder.has_episode()) {
    throw std::runtime_error(fmt::format("{}: the log has no episode {}",
                                         run.path.string(), number));
  }
  if (recorder.recording().frames.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: episode {} of the log has no TRUTH_POSES and TRACKS to record",
        run.path.string(), number));
  }
  return recorder.recording();
}

}  // namespace cell::cli
