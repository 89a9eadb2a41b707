#pragma once

#include <Eigen/Geometry>

namespace cell {

/// Pinhole camera, OpenCV convention: z of C looks ahead, x right, y down; the
/// centre of the pixel in column u and row v is seen along
/// ((u - cx) / fx, (v - cy) / fy, 1).
struct Camera {
  int width = 640;
  int height = 480;
  double fx = 600;  ///< [px]
  double fy = 600;
  double cx = 319.5;
  double cy = 239.5;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
};

/// A camera with square pixels at `p_WC` that looks at `p_WT`, z of W upwards
/// in the image.
/// @throws std::invalid_argument if it would look straight up or down, or for
/// sizes and angles that are not positive.
Camera CameraLookingAt(const Eigen::Vector3d& p_WC, const Eigen::Vector3d& p_WT,
                       int width, int height, double horizontal_view_rad);

/// A camera at X_WC with these full view angles [rad]: wide, high.
Camera CameraWithView(const Eigen::Isometry3d& X_WC, int width, int height,
                      const Eigen::Vector2d& view_angles_rad);

}  // namespace cell
