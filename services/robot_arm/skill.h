#pragma once

#include <cstdint>
#include <string>

namespace cell::robot_arm {

/// What an arm is asked to do once.
struct SkillRequest {
  enum class Kind : int8_t {
    kInsert = 0,   ///< take the part, unless held, and seat it at the site
    kPresent = 1,  ///< set it down where the other arm can take it
    kPutDown = 2,  ///< on a free place of the table
    kFetch = 3,    ///< take it and wait
    kGoHome = 4,
    /// From what a stop has left the arm at: let go of what is held if a site
    /// holds it, draw back from what is near, go home with an empty hand.
    kGoFree = 5
  };
  int64_t id = 0;
  Kind kind = Kind::kGoHome;
  std::string part;
  std::string site;
};

struct SkillResult {
  enum class Outcome : int8_t {
    kSucceeded = 0,
    kRefused = 1,  ///< nothing has moved
    kFailed = 2,
    kStopped = 3,  ///< by a protective stop
    kYielded = 4   ///< to a person: it may be asked again
  };
  int64_t id = 0;
  Outcome outcome = Outcome::kSucceeded;
  std::string reason;     ///< why not, in plain words
  double peak_force = 0;  ///< [N]
};

}  // namespace cell::robot_arm
