#include "services/cell/recordings/episode_recorder.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "cell/command_name_t.hpp"
#include "cell/tracks_t.hpp"
#include "cell/truth_action_t.hpp"
#include "common/bus/bus.h"
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

/// Nothing if it is of no kind that is known.
std::optional<Recording::TrueAction> TrueActionOf(
    const truth_action_t& message) {
  using enum Recording::TrueAction::Kind;
  Recording::TrueAction action{message.header.utime, kMoved, message.part,
                               message.site};
  switch (message.kind) {
    case truth_action_t::PLACED:
      action.kind = kPlaced;
      return action;
    case truth_action_t::TAKEN_BACK:
      action.kind = kTakenBack;
      return action;
    case truth_action_t::MOVED:
      return action;
    case truth_action_t::TIPPED:
      action.kind = kTipped;
      return action;
    default:
      return std::nullopt;
  }
}

}  // namespace

EpisodeRecorder::EpisodeRecorder(const Task& task, int number,
                                 const std::string& build)
    : number_(number) {
  head_.build = build;
  head_.bodies = BodiesOf(task);
  for (size_t i = 0; i < head_.bodies.size(); ++i) {
    index_[head_.bodies[i]] = i;
  }
}

void EpisodeRecorder::Put(const Message& message) {
  if (message.channel == "EPISODE") {
    if (const auto m = Decode<episode_t>(message)) OnEpisode(*m);
  } else if (num_started_ != number_) {
    return;
  } else if (message.channel == "TRUTH_POSES") {
    if (auto m = Decode<truth_poses_t>(message)) {
      truths_[m->header.utime] = *std::move(m);
    }
  } else if (message.channel == "COMMAND_NAME") {
    if (const auto m = Decode<command_name_t>(message)) {
      head_.spoken.push_back(
          {int64_t{message.tick} * kTickUs, m->name, m->is_undone != 0});
    }
  } else if (message.channel == "TRUTH_ACTIONS") {
    if (const auto m = Decode<truth_action_t>(message)) {
      if (auto action = TrueActionOf(*m)) head_.truth.push_back(*action);
    }
  } else if (message.channel == "TRACKS") {
    const auto m = Decode<tracks_t>(message);
    if (m && m->header.utime >= start_utime_) {
      track_utimes_.insert(m->header.utime);
    }
  }
}

Recording EpisodeRecorder::Finish() const {
  Recording recording = head_;
  for (const int64_t utime : track_utimes_) {
    const auto later = truths_.upper_bound(utime);
    if (later == truths_.begin()) continue;
    AddFrame(utime, std::prev(later)->second, &recording);
  }
  return recording;
}

void EpisodeRecorder::OnEpisode(const episode_t& message) {
  if (message.phase != episode_t::START) return;
  if (++num_started_ != number_) return;
  start_utime_ = message.header.utime;
  head_.task = message.task;
  head_.demonstration = message.demonstration;
  head_.seed = static_cast<uint64_t>(message.seed);
}

void EpisodeRecorder::AddFrame(int64_t utime, const truth_poses_t& truth,
                               Recording* recording) const {
  Recording::Frame& frame = recording->frames.emplace_back();
  frame.utime = utime;
  frame.poses.resize(head_.bodies.size());
  for (const body_pose_t& body : truth.bodies) {
    const auto index = index_.find(body.name);
    if (index == index_.end()) continue;
    frame.poses[index->second] = body.pose_world_body;
  }
}

}  // namespace cell::cli
