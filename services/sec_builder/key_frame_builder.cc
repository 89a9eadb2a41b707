#include "services/sec_builder/key_frame_builder.h"

#include <cstdint>
#include <map>
#include <string>

namespace cell::sec_builder {
namespace {

// Parts of a type that several have.
ObjectTypes AlikeParts(const PartTable& parts) {
  std::map<std::string, int> num_of_type;
  for (const Part& part : parts.parts()) ++num_of_type[part.type];
  ObjectTypes alike;
  for (const Part& part : parts.parts()) {
    if (num_of_type[part.type] > 1) alike[part.name] = part.type;
  }
  return alike;
}

}  // namespace

KeyFrameBuilder::Params KeyFrameBuilder::Params::Load(
    const Deployment& deployment, const Task& task) {
  Params params{task.scene_objects, task.parts, {}, {}, {}};
  const Config config = deployment.ForService("sec_builder");
  PairFilter::Params& pair = params.extractor.pair;
  pair.touch = config.Number("touch_mm", 0.01, 1000) * 1e-3;
  pair.release = config.Number("release_mm", 0.01, 1000) * 1e-3;
  if (pair.release < pair.touch) {
    config["release_mm"].Fail("must not be less than touch_mm");
  }
  pair.stick_out = pair.release - pair.touch;
  pair.confirm_frames = config.Integer("confirm_frames", 1, 100);
  pair.backdate_us = config.Integer("backdate_ms", 0, 10'000) * int64_t{1000};
  params.extractor.merge_us =
      config.Integer("merge_ms", 0, 10'000) * int64_t{1000};
  params.extractor.absent_us =
      config.Integer("absent_ms", 1, 1'000'000) * int64_t{1000};
  params.extractor.alike = AlikeParts(task.parts);
  params.smoother.position_sd = config.Number("pose_noise_mm", 0, 100) * 1e-3;
  params.smoother.lag_frames = config.Integer("lag_frames", 1, 100);
  params.emulation = KeyFrameEmulation::Params::FromConfig(config["emulation"]);
  params.layers = LayerSensor::Params::FromConfig(config);
  config.Finish();
  for (const ArmLayout& arm : task.layout.arms) {
    const std::string suffix = ChannelSuffix(arm.name);
    auto& channels = params.extractor.channels[arm.gripper];
    channels = {"ARM_STATE_" + suffix};
    if (arm.X_FS) channels.push_back("WRENCH_" + suffix);
  }
  params.proximity = {pair.touch / 2, 1.5 * pair.release};
  return params;
}

KeyFrameBuilder::KeyFrameBuilder(const Params& params)
    : params_(params),
      smoother_(params.smoother),
      sensor_(params.scene_objects, params.parts, params.proximity),
      extractor_(params.scene_objects, params.extractor),
      emulation_(params.scene_objects, params.emulation),
      layer_sensor_(params.scene_objects, params.parts, params.layers) {}

std::vector<KeyFrame> KeyFrameBuilder::Update(const Tracks& tracks) {
  const auto smooth = smoother_.Update(tracks);
  layers_.clear();
  if (!smooth) return {};
  std::vector<KeyFrame> frames = emulation_.Update(
      tracks.utime, extractor_.Update(*smooth, sensor_.Measure(*smooth)));
  if (params_.layers.is_on()) {
    layer_sensor_.Update(*smooth);
    for (const KeyFrame& frame : frames) {
      layers_.push_back(layer_sensor_.Sense(frame));
    }
  }
  return frames;
}

void KeyFrameBuilder::Reset(uint64_t episode_seed) {
  smoother_ = PoseSmoother(params_.smoother);
  extractor_ = KeyFrameExtractor(params_.scene_objects, params_.extractor);
  emulation_.Reset(episode_seed);
  layer_sensor_ =
      LayerSensor(params_.scene_objects, params_.parts, params_.layers);
  layers_.clear();
}

}  // namespace cell::sec_builder
