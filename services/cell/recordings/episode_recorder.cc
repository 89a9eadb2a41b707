#include "services/cell/recordings/episode_recorder.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cell/tracks_t.hpp"
#include "common/bus/decode.h"

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

}  // namespace

EpisodeRecorder::EpisodeRecorder(const Task& task, int number,
                                 const std::string& build)
    : number_(number) {
  recording_.build = build;
  recording_.bodies = BodiesOf(task);
  for (size_t i = 0; i < recording_.bodies.size(); ++i) {
    index_[recording_.bodies[i]] = i;
  }
}

void EpisodeRecorder::Put(const Message& message) {
  if (message.channel == "EPISODE") {
    if (const auto m = Decode<episode_t>(message)) OnEpisode(*m);
  } else if (message.channel == "TRUTH_POSES") {
    if (auto m = Decode<truth_poses_t>(message)) {
      truths_[m->header.utime] = *std::move(m);
    }
  } else if (message.channel == "TRACKS" && num_started_ == number_) {
    if (const auto m = Decode<tracks_t>(message)) OnTracks(m->header.utime);
  }
}

void EpisodeRecorder::OnEpisode(const episode_t& message) {
  if (message.phase != episode_t::START) return;
  if (++num_started_ != number_) return;
  start_utime_ = message.header.utime;
  recording_.task = message.task;
  recording_.demonstration = message.demonstration;
  recording_.seed = static_cast<uint64_t>(message.seed);
}

void EpisodeRecorder::OnTracks(int64_t utime) {
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

}  // namespace cell::cli
