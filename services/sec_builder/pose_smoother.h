#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/track.h"

namespace cell::sec_builder {

/// Takes noise out of tracks with a fixed lag, without blurring the moments at
/// which things begin and cease to move: near several mm of noise, single poses
/// do not decide which objects touch.
///
/// What rests has one pose: its pose in frame k is the mean over the frames
/// before k or over those after it, whichever spread less, if the spread is
/// what noise explains (Kuwahara's edge-preserving filter, in time). A rest is
/// followed back further than the lag. So a part at rest stays on its support,
/// and its relation at the end of a motion is decided by all frames since. What
/// moves keeps the pose that a straight line through the nearest frames gives.
class PoseSmoother {
 public:
  struct Params {
    /// [m] standard deviation of each coordinate of a track; 0: no smoothing
    /// and no lag.
    double position_sd = 0;
    int lag_frames = 6;    ///< a frame comes out when so many later ones came
    int rest_frames = 40;  ///< a rest is averaged over at most so many frames
    /// What rests spreads by less than this many standard deviations (rms of
    /// the three coordinates together).
    double max_spread = 2.2;
  };

  explicit PoseSmoother(const Params& params) : params_(params) {}

  /// The smoothed tracks of the frame `lag_frames` before this one; nullopt
  /// while there is none. Without smoothing: the tracks themselves.
  std::optional<Tracks> Update(const Tracks& tracks);

 private:
  using Poses = std::deque<std::optional<Eigen::Isometry3d>>;
  struct Mean {
    Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
    double spread = 0;  // [m]
    int count = 0;
  };

  void Remember(const Tracks& tracks);
  /// Over frames first..last that have a pose.
  static Mean MeanOf(const Poses& poses, size_t first, size_t last);
  Eigen::Isometry3d Smoothed(const Poses& poses, size_t frame) const;

  Params params_;
  std::deque<Tracks> frames_;  // as they came; all of them are in poses_
  std::map<std::string, Poses> poses_;  // of each object, by frame
};

}  // namespace cell::sec_builder
