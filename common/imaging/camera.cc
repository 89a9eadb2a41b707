#include "common/imaging/camera.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cell {

Camera CameraLookingAt(const Eigen::Vector3d& p_WC, const Eigen::Vector3d& p_WT,
                       int width, int height, double horizontal_view_rad) {
  const Eigen::Vector3d ahead = p_WT - p_WC;
  const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ());
  if (!(right.norm() > 1e-9 * ahead.norm())) {
    throw std::invalid_argument("a camera cannot look straight up or down");
  }
  if (width <= 0 || height <= 0 ||
      !(horizontal_view_rad > 0 && horizontal_view_rad < std::numbers::pi)) {
    throw std::invalid_argument(
        fmt::format("a camera of {} x {} pixels and {} rad", width, height,
                    horizontal_view_rad));
  }
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = width / 2. / std::tan(horizontal_view_rad / 2);
  camera.cx = (width - 1) / 2.;
  camera.cy = (height - 1) / 2.;
  Eigen::Matrix3d R_WC;
  R_WC.col(0) = right.normalized();
  R_WC.col(2) = ahead.normalized();
  R_WC.col(1) = R_WC.col(2).cross(R_WC.col(0));
  camera.X_WC.linear() = R_WC;
  camera.X_WC.translation() = p_WC;
  return camera;
}

Camera CameraWithView(const Eigen::Isometry3d& X_WC, int width, int height,
                      const Eigen::Vector2d& view_angles_rad) {
  return {width,
          height,
          width / 2. / std::tan(view_angles_rad.x() / 2),
          height / 2. / std::tan(view_angles_rad.y() / 2),
          (width - 1) / 2.,
          (height - 1) / 2.,
          X_WC};
}

}  // namespace cell
