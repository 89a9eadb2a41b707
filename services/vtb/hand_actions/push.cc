#include "services/vtb/hand_actions.h"
#include "services/vtb/hand_actions/joint_motion.h"

namespace cell::vtb::hand_action {

HandAction Push(const std::string& part) {
  return ToLimit(part, PartJoint::Kind::kSlide, false);
}

}  // namespace cell::vtb::hand_action
