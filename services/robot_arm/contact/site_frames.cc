#include "services/robot_arm/contact/site_frames.h"

namespace cell::robot_arm {

using Eigen::Isometry3d;

Isometry3d SiteFrames::GripperAt(const Isometry3d& X_SO) const {
  return X_WS * X_SO * X_symmetry * X_GO.inverse();
}

Isometry3d SiteFrames::PartAt(const Isometry3d& X_WG) const {
  return X_WS.inverse() * X_WG * X_GO * X_symmetry.inverse();
}

double SiteFrames::HeightAt(const Isometry3d& X_WG) const {
  return (X_WS.inverse() * (X_WG * X_GO).translation()).z();
}

}  // namespace cell::robot_arm
