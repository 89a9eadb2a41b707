#include "services/robot_arm/contact/insertion.h"

#include <memory>

namespace cell::robot_arm {

using Eigen::Isometry3d;

ContactMotion MakeInsertion(const InsertionParams& params, double height) {
  return {params.contact, std::make_unique<StraightFeed>(params.feed),
          std::make_unique<SeatedTermination>(params.seat),
          Isometry3d(Eigen::Translation3d(0, 0, height))};
}

ContactMotionMaker InsertionMaker(const InsertionParams& params) {
  return [params](const SiteFrames& frames, const Isometry3d& X_WG) {
    return MakeInsertion(params, frames.HeightAt(X_WG));
  };
}

}  // namespace cell::robot_arm
