#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "common/config/config.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"

namespace cell::sec_builder {

/// Emulates the mid level (sections II-B3, IV): gives true key frames the
/// errors of an imperfect estimator, so that recognition and planning can be
/// studied without the levels below. With `sensing: ideal` the tracks, and so
/// the key frames, are ground truth.
///
/// The same seed and key frames give the same errors.
class KeyFrameEmulation {
 public:
  struct Params {
    double missed = 0;  ///< probability that the change of a pair is not seen
    /// Probability that it is ascribed to another pair of one of the objects,
    /// until the next key frame.
    double wrong = 0;
    double late = 0;              ///< probability that a key frame is late ...
    int64_t late_us = 1'000'000;  ///< ... by this
    uint64_t seed = 1;

    bool is_on() const { return missed > 0 || wrong > 0 || late > 0; }
    /// Reads missed, wrong, late, late_ms, seed. @throws ConfigError.
    static Params FromConfig(const Config& config);
  };

  KeyFrameEmulation(const SceneObjects& scene_objects, const Params& params);

  /// The key frames that are known at `utime`, in their order. A change that
  /// was missed is made up for when its pair changes again.
  /// @param frames  true ones, later than those before
  std::vector<KeyFrame> Update(int64_t utime, std::vector<KeyFrame> frames);

  /// Another episode begins, whose own seed decides its errors, too.
  void Reset(uint64_t episode_seed);

 private:
  struct Delayed {
    int64_t due = 0;  // [us]
    KeyFrame frame;
  };

  bool Happens(double probability);
  void Perceive(const TouchGraph& truth);
  std::optional<ObjectPair> AnotherPair(const ObjectPair& pair);

  SceneObjects scene_objects_;
  Params params_;
  std::mt19937_64 random_;
  TouchGraph truth_, perceived_;  // of the last key frame; empty: none yet
  TouchGraph published_;
  std::set<ObjectPair> wrong_;  // in perceived_
  std::deque<Delayed> delayed_;
  int64_t next_index_ = 0;
};

}  // namespace cell::sec_builder
