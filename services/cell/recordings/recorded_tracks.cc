#include "services/cell/recordings/recorded_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/geometry/pose.h"
#include "common/geometry/truth_poses.h"
#include "common/text/printable.h"

namespace cell::cli {
namespace {

bool IsOfHand(const std::string& body, const CellLayout& layout) {
  for (const CellLayout::NamedHand& hand : layout.AllHands()) {
    for (const HandType::Box& box : hand.type->boxes) {
      if (body == hand.name + "." + box.name) return true;
    }
  }
  return false;
}

}  // namespace

RecordedTracks::RecordedTracks(Recording recording,
                               const SceneObjects& scene_objects,
                               const CellLayout& layout,
                               const tracker::IdealTracker::Params& params)
    : recording_(std::move(recording)),
      scene_objects_(scene_objects),
      tracker_(scene_objects, layout, params) {
  for (const std::string& body : recording_.bodies) {
    if (scene_objects.IsPart(body) || IsOfHand(body, layout)) continue;
    throw RecordingError(fmt::format(
        "the recording of task {} has a body '{}', which is no part and no box "
        "of a hand of this task",
        Printable(recording_.task), Printable(body)));
  }
}

std::optional<Tracks> RecordedTracks::Next() {
  if (next_frame_ == recording_.frames.size()) return std::nullopt;
  const Recording::Frame& frame = recording_.frames[next_frame_++];
  TruthPoses truth{frame.utime, {}};
  for (size_t i = 0; i < frame.poses.size(); ++i) {
    if (!frame.poses[i]) continue;
    truth.poses.emplace(recording_.bodies[i],
                        PoseFromMessage(*frame.poses[i]).value());
  }
  return TracksFromMessage(
      TracksToMessage(tracker_.Update(truth), scene_objects_), scene_objects_);
}

}  // namespace cell::cli
