#pragma once

#include <memory>
#include <optional>

#include "cell/episode_t.hpp"
#include "cell/key_frame_t.hpp"
#include "common/bus/bus.h"
#include "common/config/deployment.h"
#include "common/sec/cast.h"
#include "services/recognizer/recognition.h"

namespace cell::recognizer {

/// KEY_FRAME -> ACTION: names manipulations, forward or reversed, and tells
/// unknown ones (section VII-A).
class Recognizer final : public Service {
 public:
  struct Params {
    Cast cast;
    PartTable parts;
    std::shared_ptr<const Gallery> gallery;
    std::shared_ptr<const PredicateSensor> sensor;
    Recognition::Params recognition;
  };

  /// `bus` must outlive this object.
  Recognizer(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnKeyFrame(const key_frame_t& message);
  void Begin();

  Bus& bus_;
  Params params_;
  std::unique_ptr<Recognition> recognition_;  // of the episode
  int64_t start_utime_ = 0;                   // of the episode
  int64_t last_key_frame_ = -1;
  int64_t next_index_ = 0;
};

std::unique_ptr<Service> MakeRecognizer(Bus& bus, const Deployment& deployment);

}  // namespace cell::recognizer
