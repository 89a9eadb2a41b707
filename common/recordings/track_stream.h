#pragma once

#include <optional>

#include "common/scene/track.h"

namespace cell {

/// What TRACKS would carry, one measurement after another.
class TrackStream {
 public:
  TrackStream() = default;
  TrackStream(const TrackStream&) = delete;
  TrackStream& operator=(const TrackStream&) = delete;
  virtual ~TrackStream() = default;

  /// The next tracks, whose utime is later than that of the last ones; nullopt
  /// at the end.
  virtual std::optional<Tracks> Next() = 0;
};

}  // namespace cell
