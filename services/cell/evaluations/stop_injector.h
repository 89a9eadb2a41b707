#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "cell/arm_report_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "common/bus/sim_bus.h"
#include "common/geometry/truth_poses.h"
#include "common/skills/skill_arguments.h"
#include "services/cell/evaluations/stop_choice.h"
#include "services/cell/scoring/pose_history.h"
#include "services/cell/scoring/success_criterion.h"

namespace cell::cli {

/// A stop that was made, and what came of it.
struct MadeStop {
  StopKind kind = StopKind::kProtective;
  int32_t tick = 0;
  int32_t end_tick = 0;  ///< the operator resumes, or the service restarts
  std::string arm;
  std::string part;   ///< of the arm's skill
  std::string stage;  ///< in which it was; empty: between two skills
  /// Until the arm was at work again: the part that was placed before and moved
  /// most, and how far [m].
  std::string moved_part;
  double moved = 0;
};

/// Stops the arms of a run, once in each skill that is asked for with a part,
/// through what every cell has: an operator's commands, a fault of a device of
/// the testbed, the death of a service. Reads ground truth to see what moves.
class StopInjector {
 public:
  /// All must outlive this object.
  StopInjector(SimBus& bus, const SuccessCriterion& success, uint64_t seed)
      : bus_(bus), success_(success), seed_(seed) {}

  /// Messages in canonical order. Those that do not decode are passed over.
  void Put(const Message& message);
  const std::vector<MadeStop>& stops() const { return stops_; }

 private:
  /// Of an arm.
  struct Skill {
    int64_t request = -1;
    std::string phase;
    std::optional<StopChoice> choice;  ///< for this request, until it is made
  };
  using Key =
      std::tuple<std::string, std::string, std::string>;  // arm, skill, part

  void OnReport(const arm_report_t& report);
  void Choose(const asked_skill_t& request, Skill& skill);
  void Make(const StopChoice& choice, const std::string& arm,
            const std::string& part);
  void Command(int32_t tick, const std::string& channel, auto message);
  void OnPoses(const truth_poses_t& poses);
  void Remember(const TruthPoses& truth);

  SimBus& bus_;
  const SuccessCriterion& success_;
  uint64_t seed_;
  std::map<std::string, Skill> skills_;  // by arm
  std::map<int64_t, asked_skill_t> requests_;
  std::map<Key, int> num_tried_;
  std::map<StoppedSkill, int> num_of_;
  std::vector<MadeStop> stops_;
  PoseHistory looks_;
  bool is_watching_ = false;                       // the last stop
  std::map<std::string, Eigen::Vector3d> placed_;  // when it was made, in W
};

}  // namespace cell::cli
