#include "common/imaging/rgbd_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/pose.h"
#include "common/imaging/colour_codec.h"
#include "common/imaging/depth_codec.h"

namespace cell {
namespace {

constexpr int kQualityStep = 15;
constexpr int kLeastQuality = 10;

bool IsPositive(double value) {
  return std::isfinite(value) && value > 0;
}

std::optional<Camera> ViewFromMessage(const rgbd_frame_t& message) {
  const auto X_WC = PoseFromMessage(message.pose_world_camera);
  if (!X_WC || !IsPictureSize(message.width, message.height) ||
      !IsPositive(message.fx) || !IsPositive(message.fy) ||
      !std::isfinite(message.cx) || !std::isfinite(message.cy)) {
    return std::nullopt;
  }
  return Camera{message.width, message.height, message.fx, message.fy,
                message.cx,    message.cy,     *X_WC};
}

}  // namespace

std::optional<rgbd_frame_t> FrameToMessage(const RgbdFrame& frame,
                                           int max_bytes, int quality) {
  rgbd_frame_t message{};
  message.header.utime = frame.utime;
  message.camera = frame.camera;
  message.width = frame.view.width;
  message.height = frame.view.height;
  message.fx = frame.view.fx;
  message.fy = frame.view.fy;
  message.cx = frame.view.cx;
  message.cy = frame.view.cy;
  message.pose_world_camera = PoseToMessage(frame.view.X_WC);
  message.depth_unit = frame.depth_unit;
  message.depth_format = rgbd_frame_t::PLANAR_ZSTD;
  message.colour_format = rgbd_frame_t::JPEG;
  message.depth = EncodeDepth(frame.depth);
  message.num_depth_bytes = static_cast<int32_t>(message.depth.size());
  for (;;) {
    message.colour = EncodeColour(frame.colour, quality);
    message.num_colour_bytes = static_cast<int32_t>(message.colour.size());
    if (message.getEncodedSize() <= max_bytes) return message;
    if (quality <= kLeastQuality) return std::nullopt;
    quality = std::max(quality - kQualityStep, kLeastQuality);
  }
}

std::optional<RgbdFrame> FrameFromMessage(const rgbd_frame_t& message) {
  if (message.depth_format != rgbd_frame_t::PLANAR_ZSTD ||
      message.colour_format != rgbd_frame_t::JPEG ||
      !IsPositive(message.depth_unit)) {
    return std::nullopt;
  }
  const auto view = ViewFromMessage(message);
  if (!view) return std::nullopt;
  auto colour = DecodeColour(message.colour, view->width, view->height);
  auto depth = DecodeDepth(message.depth, view->width, view->height);
  if (!colour || !depth) return std::nullopt;
  return RgbdFrame{message.header.utime, message.camera,     *view,
                   message.depth_unit,   *std::move(colour), *std::move(depth)};
}

}  // namespace cell
