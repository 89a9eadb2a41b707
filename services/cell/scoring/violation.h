#pragma once

#include <cstdint>
#include <string>

namespace cell::cli {

/// A limit that an arm has exceeded, or a collision of an arm.
struct Violation {
  enum class Kind : int8_t {
    kPosition,   ///< a joint beyond its range
    kSpeed,      ///< a joint faster than it may be
    kSetpoint,   ///< a set-point that the joints cannot reach in a tick
    kWorkspace,  ///< the gripper moves outside
    kCollision
  };
  int32_t tick = 0;
  std::string arm;
  Kind kind = Kind::kCollision;
  std::string what;  ///< in plain words
};

inline bool IsLimitBreach(const Violation& violation) {
  return violation.kind != Violation::Kind::kCollision;
}

inline const char* NameOf(Violation::Kind kind) {
  switch (kind) {
    case Violation::Kind::kPosition:
      return "position";
    case Violation::Kind::kSpeed:
      return "speed";
    case Violation::Kind::kSetpoint:
      return "set-point";
    case Violation::Kind::kWorkspace:
      return "workspace";
    case Violation::Kind::kCollision:
      return "collision";
  }
  return "";
}

}  // namespace cell::cli
