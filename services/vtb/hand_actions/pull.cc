#include "services/vtb/hand_actions.h"
#include "services/vtb/hand_actions/joint_motion.h"

namespace cell::vtb::hand_action {

HandAction Pull(const std::string& part) {
  return ToLimit(part, PartJoint::Kind::kSlide, true);
}

}  // namespace cell::vtb::hand_action
