#pragma once

#include <cstddef>
#include <vector>

#include "common/config/deployment.h"
#include "common/parts/part_table.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"
#include "common/task/task.h"
#include "services/sec_builder/key_frame_emulation.h"
#include "services/sec_builder/key_frame_extractor.h"
#include "services/sec_builder/layer_sensor.h"
#include "services/sec_builder/pose_smoother.h"
#include "services/sec_builder/proximity.h"

namespace cell::sec_builder {

/// From the tracks of an episode to its key frames (section V-B): the one way
/// that the service and offline evaluations share.
class KeyFrameBuilder {
 public:
  struct Params {
    SceneObjects scene_objects;
    PartTable parts;
    ProximitySensor::Params proximity;
    KeyFrameExtractor::Params extractor;
    PoseSmoother::Params smoother;
    KeyFrameEmulation::Params emulation = {};
    LayerSensor::Params layers = {};

    /// Of sec_builder.yaml. @throws ConfigError naming file:key.
    static Params Load(const Deployment& deployment, const Task& task);
  };

  explicit KeyFrameBuilder(const Params& params);

  /// The key frames that are certain now; indices count from 0.
  /// @pre the tracks are later than the last ones.
  std::vector<KeyFrame> Update(const Tracks& tracks);
  /// Of each of the key frames of the last Update(); none if no layer is on.
  const std::vector<RelationLayers>& layers() const { return layers_; }

  /// Key frames are known so many tracks later.
  size_t lag_frames() const {
    const bool is_smoothed = params_.smoother.position_sd > 0;
    return is_smoothed ? static_cast<size_t>(params_.smoother.lag_frames) : 0;
  }

  /// Forgets all tracks: another episode begins. Its seed matters only to
  /// emulated errors.
  void Reset(uint64_t episode_seed);

 private:
  Params params_;
  PoseSmoother smoother_;
  ProximitySensor sensor_;
  KeyFrameExtractor extractor_;
  KeyFrameEmulation emulation_;
  LayerSensor layer_sensor_;
  std::vector<RelationLayers> layers_;
};

}  // namespace cell::sec_builder
