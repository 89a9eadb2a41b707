#include "services/robot_arm/contact/screwing.h"

#include <algorithm>
#include <memory>
#include <numbers>

namespace cell::robot_arm {

using Eigen::Isometry3d;

ScrewingParams ScrewingParams::GoingOnAt(double height, double pitch) const {
  const double left = 2 * std::numbers::pi * height / pitch - early_angle;
  ScrewingParams params = *this;
  params.tight.min_angle = std::clamp(left, 0.0, tight.min_angle);
  return params;
}

ContactMotion MakeScrewing(const ScrewingParams& params, double pitch,
                           const Isometry3d& X_SO) {
  return {params.contact,
          std::make_unique<ThreadFeed>(params.thread, pitch, X_SO.linear()),
          std::make_unique<TightenedTermination>(params.tight), X_SO};
}

ContactMotionMaker ScrewingMaker(const ScrewingParams& params, double pitch) {
  return [params, pitch](const SiteFrames& frames, const Isometry3d& X_WG) {
    return MakeScrewing(params, pitch, frames.PartAt(X_WG));
  };
}

}  // namespace cell::robot_arm
