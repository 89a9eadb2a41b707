#include "common/rendering/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cell {
namespace {

/// The position of the camera along an axis of the image, and how far ahead it
/// may be: of the points at (x, z), all are within |x - at| <= slope (z -
/// ahead).
struct Fit {
  double at = 0;
  double ahead = 0;
};

class EdgeFit {
 public:
  explicit EdgeFit(double slope) : slope_(slope) {}

  void Add(double x, double z) {
    left_ = std::min(left_, z + x / slope_);
    right_ = std::min(right_, z - x / slope_);
  }
  Fit Get() const {
    return {slope_ * (left_ - right_) / 2, (left_ + right_) / 2};
  }

 private:
  double slope_;
  double left_ = std::numeric_limits<double>::infinity();
  double right_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Camera CameraThatFrames(const std::vector<Eigen::Vector3d>& p_WP,
                        const PictureShape& shape) {
  if (p_WP.empty()) {
    throw std::invalid_argument("there is nothing to take a picture of");
  }
  const Eigen::Vector3d towards(
      std::cos(shape.elevation_rad) * std::cos(shape.azimuth_rad),
      std::cos(shape.elevation_rad) * std::sin(shape.azimuth_rad),
      std::sin(shape.elevation_rad));
  Camera camera = CameraLookingAt(towards, Eigen::Vector3d::Zero(), shape.width,
                                  shape.height, shape.horizontal_view_rad);
  const double seen = 1 - 2 * shape.margin;
  EdgeFit wide(seen * shape.width / (2 * camera.fx));
  EdgeFit high(seen * shape.height / (2 * camera.fy));
  const Eigen::Matrix3d R_CW = camera.X_WC.linear().transpose();
  for (const Eigen::Vector3d& p_W : p_WP) {
    const Eigen::Vector3d p_C = R_CW * p_W;
    wide.Add(p_C.x(), p_C.z());
    high.Add(p_C.y(), p_C.z());
  }
  const Fit x = wide.Get();
  const Fit y = high.Get();
  camera.X_WC.translation() =
      camera.X_WC.linear() *
      Eigen::Vector3d(x.at, y.at, std::min(x.ahead, y.ahead));
  return camera;
}

}  // namespace cell
