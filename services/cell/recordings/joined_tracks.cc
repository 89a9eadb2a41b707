#include "services/cell/recordings/joined_tracks.h"

#include <utility>

namespace cell::cli {

std::optional<Tracks> JoinedTracks::Next() {
  if (!stream_ && !Open()) return std::nullopt;
  if (first_) {
    const int64_t begin = first_->utime + offsets_.back();
    if (last_utime_ && *last_utime_ + params_.period_us < begin) {
      *last_utime_ += params_.period_us;
      return Tracks{*last_utime_, {}};
    }
  }
  std::optional<Tracks> tracks =
      first_ ? std::exchange(first_, std::nullopt) : stream_->Next();
  if (!tracks) {
    stream_.reset();
    return Next();
  }
  tracks->utime += offsets_.back();
  last_utime_ = tracks->utime;
  return tracks;
}

/// False if there are no more demonstrations; those without tracks are passed
/// over.
bool JoinedTracks::Open() {
  while (true) {
    stream_ = source_();
    if (!stream_) return false;
    first_ = stream_->Next();
    offsets_.push_back(first_ && last_utime_
                           ? *last_utime_ + params_.gap_us - first_->utime
                           : 0);
    if (first_) return true;
  }
}

}  // namespace cell::cli
