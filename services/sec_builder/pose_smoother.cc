#include "services/sec_builder/pose_smoother.h"

#include <algorithm>
#include <cmath>

namespace cell::sec_builder {

using Eigen::Isometry3d;
using Eigen::Vector3d;

std::optional<Tracks> PoseSmoother::Update(const Tracks& tracks) {
  if (params_.position_sd == 0) return tracks;
  Remember(tracks);
  const auto lag = static_cast<size_t>(params_.lag_frames);
  if (frames_.size() <= lag) return std::nullopt;
  const size_t frame = frames_.size() - 1 - lag;
  Tracks smooth = frames_[frame];
  for (Track& track : smooth.tracks) {
    if (track.state != Track::State::kTracked) continue;
    const Isometry3d X_WO = Smoothed(poses_.at(track.name), frame);
    const Vector3d shift = X_WO.translation() - track.X_WO.translation();
    for (Vector3d& point : track.points) point += shift;
    track.X_WO = X_WO;
  }
  return smooth;
}

void PoseSmoother::Remember(const Tracks& tracks) {
  frames_.push_back(tracks);
  for (const Track& track : tracks.tracks) {
    poses_.try_emplace(track.name, Poses(frames_.size() - 1));
  }
  const auto capacity =
      static_cast<size_t>(params_.rest_frames + params_.lag_frames + 1);
  const bool is_full = frames_.size() > capacity;
  if (is_full) frames_.pop_front();
  for (auto& [name, poses] : poses_) {
    const Track* track = tracks.Find(name);
    const bool is_seen =
        track != nullptr && track->state == Track::State::kTracked;
    poses.push_back(is_seen ? std::optional(track->X_WO) : std::nullopt);
    if (is_full) poses.pop_front();
  }
}

PoseSmoother::Mean PoseSmoother::MeanOf(const Poses& poses, size_t first,
                                        size_t last) {
  Mean mean;
  Vector3d sum = Vector3d::Zero();
  Eigen::Vector4d rotations = Eigen::Vector4d::Zero();
  double squares = 0;
  for (size_t i = first; i <= last; ++i) {
    if (!poses[i]) continue;
    const Eigen::Quaterniond q(poses[i]->linear());
    const double sign = rotations.dot(q.coeffs()) < 0 ? -1 : 1;
    rotations += sign * q.coeffs();
    sum += poses[i]->translation();
    ++mean.count;
  }
  if (mean.count == 0) return mean;
  const Vector3d centre = sum / mean.count;
  for (size_t i = first; i <= last; ++i) {
    if (poses[i]) squares += (poses[i]->translation() - centre).squaredNorm();
  }
  mean.spread = std::sqrt(squares / mean.count);
  mean.X_WO = Isometry3d(Eigen::Quaterniond(rotations).normalized());
  mean.X_WO.translation() = centre;
  return mean;
}

Isometry3d PoseSmoother::Smoothed(const Poses& poses, size_t frame) const {
  const auto lag = static_cast<size_t>(params_.lag_frames);
  const size_t last = std::min(frame + lag, poses.size() - 1);
  const size_t first = frame < lag ? 0 : frame - lag;
  const double limit = params_.max_spread * params_.position_sd;
  Mean before = MeanOf(poses, first, frame);
  const Mean after = MeanOf(poses, frame, last);
  const bool is_before = before.count > 1 && before.spread < limit;
  const bool is_after = after.count > 1 && after.spread < limit;
  if (is_before && (!is_after || before.spread <= after.spread)) {
    const Mean longer = MeanOf(poses, 0, frame);
    return longer.spread < limit ? longer.X_WO : before.X_WO;
  }
  if (is_after) return after.X_WO;
  // A straight line through neighbours that are as far on either side.
  const size_t near = std::min<size_t>({1, frame - first, last - frame});
  return MeanOf(poses, frame - near, frame + near).X_WO;
}

}  // namespace cell::sec_builder
