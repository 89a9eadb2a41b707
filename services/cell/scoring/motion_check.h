#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "common/bus/message.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/cell/scoring/arm_activity.h"
#include "services/cell/scoring/collision_check.h"
#include "services/cell/scoring/limit_check.h"
#include "services/cell/scoring/violation.h"

namespace cell::cli {

/// Checks, from the messages of a run, that its arms kept their limits and hit
/// nothing. An arm at rest has not hit what a person's hand moves against it.
/// Reads ground truth, so no service may use it.
class MotionCheck {
 public:
  MotionCheck(const CellLayout& layout, const PartTable& parts);
  MotionCheck(const MotionCheck&) = delete;
  MotionCheck& operator=(const MotionCheck&) = delete;

  /// Messages as they were published: in each tick the clock's, then the
  /// services'. Those that do not decode are counted.
  void Put(const Message& message);

  /// As they were found; each pair of bodies, or each joint, once a skill.
  const std::vector<Violation>& violations() const { return violations_; }
  int num_protective_stops() const;
  /// Why the violations may not be all there are, e.g. "ARM_STATE_LEFT: 3 of 5
  /// messages are damaged or of another type than this program's"; empty if
  /// everything was seen.
  std::vector<std::string> Gaps() const;

 private:
  struct Channel {
    std::function<bool(const Message&)> handler;  // false: does not decode
    bool is_needed = false;
    int num_messages = 0;
    int num_unreadable = 0;
  };

  bool OnState(const std::string& arm, const Message& message);
  bool OnSetpoint(const std::string& arm, const Message& message);
  bool OnReport(const std::string& arm, const Message& message);
  bool OnRequest(const Message& message);
  bool OnPoses(const Message& message);
  bool OnEpisode(const Message& message);
  void Add(const std::string& arm, int32_t tick, LimitCheck::Breach breach);

  std::map<std::string, Channel> channels_;
  std::map<std::string, LimitCheck> limits_;       // by arm
  std::map<std::string, ArmActivity> activities_;  // by arm
  std::map<std::string, bool> is_moving_;          // by arm
  CollisionCheck collisions_;
  /// Arm, skill, kind and subject of what has been found.
  std::set<std::tuple<std::string, int64_t, Violation::Kind, std::string>>
      known_;
  std::vector<Violation> violations_;
};

}  // namespace cell::cli
