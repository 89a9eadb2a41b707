#include "services/vtb/mujoco_pose.h"

namespace cell::vtb {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Isometry3d PoseFromMujoco(const mjtNum* position, const mjtNum* quat_wxyz) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(position[0], position[1], position[2]);
  X.linear() =
      Quaterniond(quat_wxyz[0], quat_wxyz[1], quat_wxyz[2], quat_wxyz[3])
          .normalized()
          .toRotationMatrix();
  return X;
}

void PoseToMujoco(const Isometry3d& X, mjtNum* position, mjtNum* quat_wxyz) {
  const Quaterniond q(X.linear());
  for (int i = 0; i < 3; ++i) position[i] = X.translation()[i];
  quat_wxyz[0] = q.w();
  quat_wxyz[1] = q.x();
  quat_wxyz[2] = q.y();
  quat_wxyz[3] = q.z();
}

void SetWeld(const Isometry3d& X_1O, const Vector3d& centre, mjModel& model,
             int equality) {
  mjtNum* data = model.eq_data + mjNEQDATA * equality;
  Isometry3d X_1C = X_1O;
  X_1C.translation() = X_1O * centre;
  Eigen::Map<Vector3d>(data, 3) = centre;
  PoseToMujoco(X_1C, data + 3, data + 6);
  data[10] = 1;
}

}  // namespace cell::vtb
