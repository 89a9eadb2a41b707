#pragma once

#include <string>

#include "services/vtb/hand_stage.h"

namespace cell::vtb::hand_action {

/// A held part along its joint to a limit, as Open() and its like do.
HandAction ToLimit(const std::string& part, PartJoint::Kind kind,
                   bool is_upper);

}  // namespace cell::vtb::hand_action
