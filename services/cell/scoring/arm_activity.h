#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "cell/arm_report_t.hpp"
#include "cell/asked_skill_t.hpp"

namespace cell::cli {

/// The activity of one arm by its requests and reports: decides what
/// its hand and the part in it may touch.
class ArmActivity {
 public:
  /// A request to this arm.
  void OnRequest(const asked_skill_t& request);
  void OnReport(const arm_report_t& report);

  /// Id of the skill that runs, or ran last; -1: none so far.
  int64_t skill() const { return skill_; }
  /// The phase that this skill is in, or was in last.
  const std::string& phase() const { return phase_; }
  /// Part in the gripper; empty: none.
  const std::string& held() const { return held_; }
  /// Part that the hand may touch, from closing until it has drawn back;
  /// empty: none.
  const std::string& grasped() const { return grasped_; }

  /// The held part may touch other parts and what carries them.
  bool IsHeldAmongParts() const;
  /// The held part may touch the table.
  bool IsHeldAtTable() const;

 private:
  std::map<int64_t, std::string> parts_;  // by request
  int64_t skill_ = -1;
  std::string phase_, held_, grasped_;
  int8_t contact_ = arm_report_t::NO_CONTACT;  // that the phase permits
};

}  // namespace cell::cli
