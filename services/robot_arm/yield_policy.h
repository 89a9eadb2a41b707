#pragma once

namespace cell::robot_arm {

/// What an arm does when another arm blocks its path. One of the two tries
/// again later, so that they do not start and stop each other endlessly, and
/// gives up sooner, which makes room for the other. Pure.
class YieldPolicy {
 public:
  enum class Advice {
    kGo,
    kWait,      ///< stand still in this tick
    kGoAround,  ///< the same, and look for another way
    kGiveUp
  };
  explicit YieldPolicy(bool goes_first) : goes_first_(goes_first) {}

  /// One tick of `dt` [s]. `is_blocked`: it would meet another arm soon.
  Advice Step(bool is_blocked, double dt);

 private:
  bool goes_first_;
  double pause_ = 0;   // [s] until it tries again
  double waited_ = 0;  // [s] in all, since it went freely
  double tried_ = 0;   // of it, when it looked for another way
  double free_ = 0;    // [s] that it has gone
};

}  // namespace cell::robot_arm
