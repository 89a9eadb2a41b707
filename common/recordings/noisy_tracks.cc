#include "common/recordings/noisy_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cell {
namespace {

constexpr double kUs = 1e6;

void RequireSound(const NoisyTracks::Params& params) {
  for (const double value :
       {params.position_sd, params.rotation_sd, params.point_sd,
        params.correlation_s, params.dropout_s, params.swap_s}) {
    if (!(value >= 0)) {
      throw std::invalid_argument(
          fmt::format("noise of tracks: {} is negative", value));
    }
  }
  for (const double value :
       {params.dropout_probability, params.swap_probability}) {
    if (!(value >= 0 && value <= 1)) {
      throw std::invalid_argument(
          fmt::format("noise of tracks: {} is no probability", value));
    }
  }
}

Eigen::Quaterniond Rotation(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation / angle));
}

}  // namespace

NoisyTracks::NoisyTracks(std::unique_ptr<TrackStream> truth, Params params)
    : truth_(std::move(truth)),
      params_(std::move(params)),
      random_(params_.seed) {
  RequireSound(params_);
}

std::optional<Tracks> NoisyTracks::Next() {
  std::optional<Tracks> tracks = truth_->Next();
  if (!tracks) return std::nullopt;
  Tracks noisy{tracks->utime, {}};
  for (Track& track : tracks->tracks) {
    const auto [it, is_new] = noises_.try_emplace(track.name);
    Advance(tracks->utime, it->second, is_new);
    if (tracks->utime < it->second.hidden_until) continue;
    Disturb(it->second, track);
    noisy.tracks.push_back(std::move(track));
  }
  last_utime_ = tracks->utime;
  Exchange(noisy);
  return noisy;
}

Eigen::Vector3d NoisyTracks::Normal(double sd) {
  if (sd == 0) return Eigen::Vector3d::Zero();
  std::normal_distribution<double> normal(0, sd);
  const double x = normal(random_), y = normal(random_), z = normal(random_);
  return {x, y, z};
}

bool NoisyTracks::Happens(double probability) {
  return probability > 0 &&
         std::uniform_real_distribution<double>()(random_) < probability;
}

int64_t NoisyTracks::After(int64_t utime, double mean_s) {
  if (mean_s == 0) return utime + 1;
  std::exponential_distribution<double> length(1 / (mean_s * kUs));
  return utime + 1 + static_cast<int64_t>(length(random_));
}

void NoisyTracks::Advance(int64_t utime, PoseNoise& noise, bool is_new) {
  const double dt = static_cast<double>(utime - last_utime_) / kUs;
  const double a = is_new || params_.correlation_s == 0
                       ? 0
                       : std::exp(-dt / params_.correlation_s);
  const double b = std::sqrt(1 - a * a);
  noise.position = a * noise.position + b * Normal(params_.position_sd);
  noise.rotation = a * noise.rotation + b * Normal(params_.rotation_sd);
  if (utime >= noise.hidden_until && Happens(params_.dropout_probability)) {
    noise.hidden_until = After(utime, params_.dropout_s);
  }
}

// About the origin of the track, which for a hand is its centroid.
void NoisyTracks::Disturb(const PoseNoise& noise, Track& track) {
  const Eigen::Quaterniond R = Rotation(noise.rotation);
  const Eigen::Vector3d centre = track.X_WO.translation();
  for (Eigen::Vector3d& point : track.points) {
    point = centre + R * (point - centre) + noise.position +
            Normal(params_.point_sd);
  }
  if (track.points.empty()) track.X_WO.linear() = R * track.X_WO.linear();
  track.X_WO.translation() += noise.position;
}

void NoisyTracks::Exchange(Tracks& tracks) {
  if (swap_ && tracks.utime >= swap_->until) swap_.reset();
  if (!swap_ && !params_.alike.empty() && Happens(params_.swap_probability)) {
    std::uniform_int_distribution<size_t> any(0, params_.alike.size() - 1);
    swap_ =
        Swap{params_.alike[any(random_)], After(tracks.utime, params_.swap_s)};
  }
  if (!swap_) return;
  for (Track& track : tracks.tracks) {
    if (track.name == swap_->names.first) {
      track.name = swap_->names.second;
    } else if (track.name == swap_->names.second) {
      track.name = swap_->names.first;
    }
  }
  std::ranges::sort(tracks.tracks, {}, &Track::name);
}

}  // namespace cell
