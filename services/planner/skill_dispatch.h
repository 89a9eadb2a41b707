#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/planner/arm_states.h"
#include "services/planner/decisions.h"
#include "services/planner/failure_history.h"

namespace cell::planner {

/// A skill that an arm was asked for and that has not ended.
struct RunningSkill {
  SkillRequest request;
  std::optional<GroundAction> action;  ///< nullopt: going free, cleaning up
  State before = State(0);             ///< the action was planned for it
  int64_t heard_utime = 0;  ///< [us] asked, or when the arm last reported it
};

/// One that has ended, or that was lost.
struct EndedSkill {
  RunningSkill skill;
  int64_t utime = 0;  ///< [us]
  bool has_succeeded = false;
  bool counts = false;  ///< as an attempt: neither stopped nor yielded
  std::string reason;
};

/// Which arm runs which skill. An arm with a skill interrupted by a stop or the
/// death of its service first has to go free: until then the parts that are
/// sensed may be under strain. An action that fails again and again without a
/// change of the state is blocked (FailureHistory).
class SkillDispatch {
 public:
  struct Params {
    int64_t deadline_us = 1'000'000;  ///< for a skill to begin
    /// An idle arm that was asked so long ago has lost the request.
    int64_t lost_us = 500'000;
    int max_attempts = 3;  ///< of an action in one state
  };

  /// Reports of arms count from `since_utime` on.
  SkillDispatch(std::shared_ptr<const Vocabulary> vocabulary,
                const Params& params, int64_t since_utime);

  void Update(const ArmState& report) { arms_.Update(report); }
  /// Nullopt if the request is not ours.
  std::optional<EndedSkill> Update(const SkillResult& result);
  /// Ends requests to arms that have been idle for too long since: they have
  /// restarted and lost the request.
  std::vector<EndedSkill> EndLostRequests();

  /// All arms have reported since the last end of a skill.
  bool HaveArmsReported() const {
    return arms_.HaveReportedSince(since_utime_);
  }
  bool AreArmsIdle() const { return arms_.AreIdle(); }
  bool IsFree(int arm) const;
  bool HasFreeArm() const;
  bool HasArmToFree() const { return !to_free_.empty(); }
  const std::map<int, RunningSkill>& running() const { return running_; }
  const ArmStates& arms() const { return arms_; }
  FailureHistory& failures() { return failures_; }
  const FailureHistory& failures() const { return failures_; }

  /// Asks the arm, which must be free.
  void Start(SkillRequest request, std::optional<GroundAction> action,
             const State& before, Instant now, Decisions& out);
  /// Asks idle arms with an interrupted skill to go free.
  void StartGoingFree(Instant now, Decisions& out);

  /// "Present(lid), Insert(bolt_1, hole_1)"; empty if nothing runs.
  std::string ShowRunning(const RuleSet& rules) const;

 private:
  EndedSkill End(int arm, int64_t utime, bool has_succeeded, bool counts,
                 const std::string& reason);
  void OnFreed(int arm, bool has_succeeded);

  Params params_;
  ArmStates arms_;
  FailureHistory failures_;
  int64_t since_utime_;
  std::map<int, RunningSkill> running_;  // by arm
  /// Arms with an interrupted skill, and how often they failed to go free.
  std::map<int, int> to_free_;
};

}  // namespace cell::planner
