#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "cell/truth_poses_t.hpp"

namespace cell::cli {

/// The last poses of an episode and earlier ones, far enough apart to tell what
/// rests. Times that only a message claims may be anything: looks that are not
/// in order begin anew.
class PoseLooks {
 public:
  static constexpr int64_t kApartUs = 200'000;

  void Put(truth_poses_t poses) {
    if (!looks_.empty() && poses.header.utime <= looks_.back().header.utime) {
      looks_.clear();
    }
    looks_.push_back(std::move(poses));
    while (looks_.size() > 1 && IsApart(looks_[1])) looks_.pop_front();
  }
  bool has_both() const { return !looks_.empty() && IsApart(looks_.front()); }
  bool is_empty() const { return looks_.empty(); }
  /// With has_both(): at least kApartUs before last().
  const truth_poses_t& earlier() const { return looks_.front(); }
  /// Unless is_empty().
  const truth_poses_t& last() const { return looks_.back(); }

 private:
  bool IsApart(const truth_poses_t& look) const {
    return looks_.back().header.utime >= kApartUs &&
           look.header.utime <= looks_.back().header.utime - kApartUs;
  }

  std::deque<truth_poses_t> looks_;  // utimes rise
};

}  // namespace cell::cli
