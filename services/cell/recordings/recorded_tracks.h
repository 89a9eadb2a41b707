#pragma once

#include "common/layout/cell_layout.h"
#include "common/recordings/recording.h"
#include "common/recordings/track_stream.h"
#include "common/scene/scene_objects.h"
#include "services/tracker/ideal_tracker.h"

namespace cell::cli {

/// The tracks that perfect sensing publishes of a recording (`sensing: ideal`),
/// rounded as their message rounds them.
class RecordedTracks final : public TrackStream {
 public:
  /// @throws RecordingError if the recording has a body that is no part and no
  /// box of a hand of the task.
  RecordedTracks(Recording recording, const SceneObjects& scene_objects,
                 const CellLayout& layout,
                 const tracker::IdealTracker::Params& params);

  std::optional<Tracks> Next() override;

 private:
  Recording recording_;
  SceneObjects scene_objects_;
  tracker::IdealTracker tracker_;
  size_t next_frame_ = 0;
};

}  // namespace cell::cli
