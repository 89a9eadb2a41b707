#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "common/recordings/track_stream.h"

namespace cell {

/// A stream of tracks as a real tracker would give it: with pose noise that is
/// correlated in time, dropouts, and swapped names. The same seed gives the
/// same tracks.
///
/// The pose noise of each track is a stationary first-order Gauss-Markov
/// process: for frames dt apart, e <- a e + sqrt(1 - a^2) n with a = exp(-dt /
/// correlation time) and n normal with the standard deviations below. A hand's
/// points move as one body, and each by its own, uncorrelated noise.
class NoisyTracks final : public TrackStream {
 public:
  struct Params {
    double position_sd = 0;       ///< [m] of each coordinate
    double rotation_sd = 0;       ///< [rad] about each axis
    double point_sd = 0;          ///< [m] of each coordinate of a hand's point
    double correlation_s = 0.15;  ///< [s] of the pose noise; 0: white
    /// Probability per track and frame that a dropout begins, and its mean
    /// length [s] (exponential): the track is left out.
    double dropout_probability = 0;
    double dropout_s = 0.3;
    /// Probability per frame that the tracks of two parts of the same type
    /// exchange their names, and for how long [s] (exponential).
    double swap_probability = 0;
    double swap_s = 0.3;
    /// Names of parts that look alike.
    std::vector<std::pair<std::string, std::string>> alike;
    uint64_t seed = 1;
  };

  /// @throws std::invalid_argument for negative numbers, and probabilities
  /// above 1.
  NoisyTracks(std::unique_ptr<TrackStream> truth, Params params);

  std::optional<Tracks> Next() override;

 private:
  struct PoseNoise {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  // [rad]
    int64_t hidden_until = 0;                            // [us]
  };
  struct Swap {
    std::pair<std::string, std::string> names;
    int64_t until = 0;  // [us]
  };

  Eigen::Vector3d Normal(double sd);
  bool Happens(double probability);
  int64_t After(int64_t utime, double mean_s);
  void Advance(int64_t utime, PoseNoise& noise, bool is_new);
  void Disturb(const PoseNoise& noise, Track& track);
  void Exchange(Tracks& tracks);

  std::unique_ptr<TrackStream> truth_;
  Params params_;
  std::mt19937_64 random_;
  std::map<std::string, PoseNoise> noises_;  // by name of the true object
  std::optional<Swap> swap_;
  int64_t last_utime_ = 0;
};

}  // namespace cell
