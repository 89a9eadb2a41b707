#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "cell/truth_poses_t.hpp"

namespace cell::cli {

/// The last poses of an episode and earlier ones, far enough apart to tell what
/// rests. Times of messages are not trusted: poses that are out of order start
/// a new history.
class PoseHistory {
 public:
  static constexpr int64_t kApartUs = 200'000;

  void Put(truth_poses_t poses) {
    if (!poses_.empty() && poses.header.utime <= poses_.back().header.utime) {
      poses_.clear();
    }
    poses_.push_back(std::move(poses));
    while (poses_.size() > 1 && IsApart(poses_[1])) poses_.pop_front();
  }
  bool has_both() const { return !poses_.empty() && IsApart(poses_.front()); }
  bool is_empty() const { return poses_.empty(); }
  /// With has_both(): at least kApartUs before last().
  const truth_poses_t& earlier() const { return poses_.front(); }
  /// Unless is_empty().
  const truth_poses_t& last() const { return poses_.back(); }

 private:
  bool IsApart(const truth_poses_t& look) const {
    return poses_.back().header.utime >= kApartUs &&
           look.header.utime <= poses_.back().header.utime - kApartUs;
  }

  std::deque<truth_poses_t> poses_;  // utimes rise
};

}  // namespace cell::cli
