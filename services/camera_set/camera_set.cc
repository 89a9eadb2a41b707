#include "services/camera_set/camera_set.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "cell/alert_t.hpp"
#include "common/parts/part_table.h"
#include "common/rendering/cell_bodies.h"
#include "common/task/task.h"
#include "services/camera_set/recorded_device.h"
#include "services/camera_set/rendered_device.h"

namespace cell::camera_set {

CameraSet::CameraSet(Bus& bus, Params params,
                     std::unique_ptr<FrameDevice> device)
    : bus_(bus), params_(std::move(params)), device_(std::move(device)) {
  bus_.Every(params_.period_ticks, params_.phase_ticks, [this] { OnPeriod(); });
}

void CameraSet::OnPeriod() {
  const auto frame = device_->Capture();
  if (!frame) return;
  const auto message =
      FrameToMessage(*frame, params_.max_bytes, params_.jpeg_quality);
  if (message) {
    bus_.Publish("FRAME_" + params_.camera, *message);
  } else if (!was_too_long_) {
    PublishTooLong();
  }
  was_too_long_ = !message;
}

void CameraSet::PublishTooLong() {
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::WARNING;
  alert.cause = alert_t::BAD_INPUT;
  alert.text = fmt::format(
      "camera {}: its frames are longer than {} bytes even at the lowest "
      "colour quality; they are not sent. In camera_set.yaml max_frame_kb is "
      "the "
      "limit (beyond it a live cell needs a larger net.core.rmem_max: cell "
      "doctor), and a smaller rendered.size or a coarser "
      "rendered.depth_unit_mm makes them shorter",
      params_.camera, params_.max_bytes);
  bus_.Publish("ALERT", alert);
}

namespace {

/// From 0, of a set called `instance`.
size_t IndexOf(const std::string& instance, size_t num_sets) {
  for (size_t i = 0; i < num_sets; ++i) {
    if (instance == std::to_string(i + 1)) return i;
  }
  throw std::invalid_argument(
      fmt::format("there is no camera set '{}': cell.yaml:cameras places {}, "
                  "called 1 to {}",
                  instance, num_sets, num_sets));
}

RenderedView::Params RenderedFromConfig(const Config& config,
                                        const CameraLayout& cameras,
                                        const Eigen::Isometry3d& X_WC) {
  const Config size = config["size"];
  const auto sides = size.As<std::vector<int>>();
  if (sides.size() != 2 || !IsPictureSize(sides[0], sides[1])) {
    size.Fail(
        fmt::format("is not [wide, high] of at most {} pixels", kMaxPixels));
  }
  RenderedView::Params params;
  params.view = CameraWithView(X_WC, sides[0], sides[1], cameras.view_angles);
  params.depth_unit = 1e-3 * config.Number("depth_unit_mm", 1e-3, 100);
  params.has_shadows = config.Get<bool>("shadows");
  return params;
}

RecordedDevice::Params RecordedFromConfig(const Config& config,
                                          const std::filesystem::path& task_dir,
                                          const Eigen::Isometry3d& X_WC) {
  return {.folder = task_dir / config.Get<std::string>("folder"),
          .is_loop = config.Get<bool>("loops"),
          .X_WC = X_WC};
}

}  // namespace

std::unique_ptr<Service> MakeCameraSet(Bus& bus, const Deployment& deployment,
                                       const std::string& instance) {
  const Task task = LoadTask(deployment);
  const CellLayout& layout = task.layout;
  if (!layout.cameras) {
    throw ConfigError("cell.yaml:cameras: missing; it places no cameras");
  }
  const auto poses = layout.cameras->Poses();
  const size_t index = IndexOf(instance, poses.size());

  const Config config = deployment.ForService("camera_set");
  CameraSet::Params params;
  params.camera = instance;
  params.period_ticks = config.Integer("period_ticks", 1, 1250);
  params.phase_ticks = config.Integer("stagger_ticks", 0, 1250) *
                       static_cast<int32_t>(index) % params.period_ticks;
  params.max_bytes = 1000 * config.Integer("max_frame_kb", 1, 10'000);
  params.jpeg_quality = config.Integer("jpeg_quality", 10, 100);
  auto rendered =
      RenderedFromConfig(config["rendered"], *layout.cameras, poses[index]);
  auto recorded =
      RecordedFromConfig(config["recorded"], deployment.task_dir, poses[index]);
  const auto device = config.Get<std::string>("device");
  config.Finish();
  rendered.camera = recorded.camera = instance;
  // In lockstep all services wait for this frame; live, it shares the cores.
  rendered.num_threads = deployment.is_live ? 1 : 0;
  recorded.folder /= instance;
  if (device == "recorded") {
    return std::make_unique<CameraSet>(
        bus, params, std::make_unique<RecordedDevice>(bus, recorded));
  }
  if (device != "rendered") {
    config["device"].Fail("'" + device + "' is neither rendered nor recorded");
  }
  return std::make_unique<CameraSet>(
      bus, params,
      std::make_unique<RenderedDevice>(bus, BodiesOf(task.parts, layout),
                                       rendered));
}

}  // namespace cell::camera_set
