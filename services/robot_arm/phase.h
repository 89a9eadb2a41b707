#pragma once

#include <cstdint>
#include <string>

namespace cell::robot_arm {

/// What the part in the gripper, or between the fingers, may touch.
enum class Contact : int8_t {
  kNone = 0,
  kParts = 1,         ///< other parts: it is being seated
  kPartsAndTable = 2  ///< also the table: it is taken or put down
};

/// What an arm is doing, for people, and which contact that permits.
struct Phase {
  std::string name;  ///< in plain words; empty: nothing
  Contact contact = Contact::kNone;
};

}  // namespace cell::robot_arm
