#pragma once

#include <memory>
#include <string>

#include "common/bus/bus.h"
#include "common/config/deployment.h"
#include "services/camera_set/frame_device.h"

namespace cell::camera_set {

/// A device's pictures -> FRAME_<SET>. Independent of episodes: its
/// frames show what is there.
class CameraSet final : public Service {
 public:
  struct Params {
    std::string camera = "1";
    int32_t period_ticks = 12;  ///< 96 ms
    int32_t phase_ticks = 0;
    int max_bytes = 150'000;  ///< of a message
    int jpeg_quality = 90;    ///< [%] unless the frame is longer then
  };

  /// `bus` must outlive this object.
  CameraSet(Bus& bus, Params params, std::unique_ptr<FrameDevice> device);

 private:
  void OnPeriod();
  void PublishTooLong();

  Bus& bus_;
  Params params_;
  std::unique_ptr<FrameDevice> device_;
  bool was_too_long_ = false;  // the frame before
};

/// The set `instance` of the task's cell.yaml: "1" is its first.
std::unique_ptr<Service> MakeCameraSet(Bus& bus, const Deployment& deployment,
                                       const std::string& instance);

}  // namespace cell::camera_set
