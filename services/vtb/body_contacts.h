#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace cell::vtb {

/// Two bodies that touch; hands touch without pushing.
struct BodyContact {
  std::string first, second;                      ///< first < second
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< of the deepest point
  double distance = 0;                            ///< [m] negative: penetration
  double normal_force = 0;  ///< [N] sum over the pair's points
};

/// The contacts that the physics found in their last step; by (first, second).
std::vector<BodyContact> ContactsOf(const mjModel& model, const mjData& data);

/// Brings contacts into the order of (first, second).
void SortByNames(std::vector<BodyContact>* contacts);

}  // namespace cell::vtb
