#pragma once

#include <optional>
#include <string>

#include "common/bus/bus.h"
#include "services/camera_set/frame_device.h"
#include "services/camera_set/recorded_frames.h"

namespace cell::camera_set {

/// A folder of recorded frames -> pictures, as if they were taken now. Content
/// of a file that yields no measurement is reported once, as an ALERT.
class RecordedDevice final : public FrameDevice {
 public:
  struct Params {
    std::string camera = "1";
    std::filesystem::path folder;
    bool is_loop = true;
    Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  };

  /// `bus` must outlive this object. @throws as RecordedFrames does.
  RecordedDevice(Bus& bus, const Params& params);

  std::optional<RgbdFrame> Capture() override;

 private:
  void PublishRemark();

  Bus& bus_;
  std::string camera_;
  Eigen::Isometry3d X_WC_;
  RecordedFrames frames_;
};

}  // namespace cell::camera_set
