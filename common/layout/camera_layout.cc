#include "common/layout/camera_layout.h"

#include <cmath>
#include <numbers>

#include "common/geometry/degree.h"
#include "common/layout/vectors.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

}  // namespace

CameraLayout CameraLayout::FromConfig(const Config& config) {
  CameraLayout cameras;
  cameras.p_W_look_at = Vector3(config, "look_at");
  cameras.distance = config.Number("distance", 0.1, 10);
  // A set that looked straight down would not know which way is up.
  cameras.elevation = kDegree * config.Number("elevation_deg", 5, 85);
  for (const Config& azimuth : config["azimuths_deg"].Items()) {
    cameras.azimuths.push_back(kDegree * azimuth.As<double>());
  }
  if (cameras.azimuths.empty()) config["azimuths_deg"].Fail("is empty");
  cameras.view_angles = kDegree * Vector2(config, "view_deg");
  if (!(cameras.view_angles.minCoeff() > 0 &&
        cameras.view_angles.maxCoeff() < std::numbers::pi)) {
    config["view_deg"].Fail("lies outside (0, 180)");
  }
  return cameras;
}

std::vector<Isometry3d> CameraLayout::Poses() const {
  std::vector<Isometry3d> poses;
  for (const double azimuth : azimuths) {
    const Vector3d back(std::cos(elevation) * std::cos(azimuth),
                        std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation));
    const Vector3d right = back.cross(-Vector3d::UnitZ()).normalized();
    Isometry3d X_WC = Isometry3d::Identity();
    X_WC.linear() << right, (-back).cross(right), -back;
    X_WC.translation() = p_W_look_at + distance * back;
    poses.push_back(X_WC);
  }
  return poses;
}

bool CameraLayout::IsInView(const Isometry3d& X_WC, const Vector3d& p_W) const {
  const Vector3d p_C = X_WC.inverse() * p_W;
  return p_C.z() > 0 &&
         std::abs(p_C.x()) <= p_C.z() * std::tan(view_angles.x() / 2) &&
         std::abs(p_C.y()) <= p_C.z() * std::tan(view_angles.y() / 2);
}

}  // namespace cell
