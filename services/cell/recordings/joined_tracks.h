#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "common/recordings/track_stream.h"

namespace cell::cli {

/// Demonstrations one after the other as one stream. Between two of them the
/// bench is cleared and set up again: for a while nothing has a track.
class JoinedTracks final : public TrackStream {
 public:
  struct Params {
    int64_t gap_us = 3'000'000;  ///< longer than it takes to be absent
    int64_t period_us = 96'000;  ///< of the tracks in the gap
  };
  /// The next demonstration; nullptr: there is none.
  using Source = std::function<std::unique_ptr<TrackStream>()>;

  JoinedTracks(Source source, const Params& params)
      : source_(std::move(source)), params_(params) {}

  std::optional<Tracks> Next() override;

  /// Of each demonstration so far: what is added to its times [us].
  const std::vector<int64_t>& offsets() const { return offsets_; }

 private:
  bool Open();

  Source source_;
  Params params_;
  std::unique_ptr<TrackStream> stream_;
  std::optional<Tracks> first_;  // of the stream, not returned yet
  std::vector<int64_t> offsets_;
  std::optional<int64_t> last_utime_;
};

}  // namespace cell::cli
