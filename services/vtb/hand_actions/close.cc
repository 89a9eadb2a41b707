#include "services/vtb/hand_actions.h"
#include "services/vtb/hand_actions/joint_motion.h"

namespace cell::vtb::hand_action {

HandAction Close(const std::string& part) {
  return ToLimit(part, PartJoint::Kind::kHinge, false);
}

}  // namespace cell::vtb::hand_action
