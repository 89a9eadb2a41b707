#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/result/result.h"
#include "services/robot_arm/arm_reading.h"
#include "services/robot_arm/phase.h"
#include "services/robot_arm/skill_stage.h"

namespace cell::robot_arm {

/// Runs stages one after the other.
class StageRunner {
 public:
  /// A stage, or why it cannot be; nullptr if there is nothing to do.
  using Made = Result<std::unique_ptr<SkillStage>>;
  /// It is made when its turn has come, for what is known then.
  struct PendingStage {
    Phase phase;
    std::function<Made()> make;
    std::function<void()> then = {};  ///< when it is done; may be empty
  };
  enum class Status { kRunning, kDone, kFailed };

  void Add(PendingStage stage) { pending_.push_back(std::move(stage)); }
  /// Ends the stage that runs; nothing is to come.
  void Clear();

  /// `dt` [s] of the arm's time. After kDone or kFailed there is nothing left
  /// to run until more is added.
  Status Step(const ArmReading& reading, double dt, ArmCommand* command);
  /// Looks for another path of the running stage while the arm is at rest.
  void SeekOtherWay();
  /// Takes it once it is known; `dt` [s] have passed with the arm at rest.
  void TryOtherWay(double dt);

  /// Where the joints will be after these times [s]; none if nothing runs.
  std::vector<std::optional<Joints>> Ahead(const std::vector<double>& seconds,
                                           const Joints& q) const;
  bool is_running() const { return stage_ != nullptr; }
  const Phase& phase() const { return phase_; }
  /// Anything has moved since this object was made.
  bool has_moved() const { return has_moved_; }
  /// Why the last step has failed.
  const Failure& failure() const { return failure_; }

 private:
  bool BeginNext();
  void FinishFirst();
  Status Fail(const Failure& failure);

  std::deque<PendingStage> pending_;
  std::unique_ptr<SkillStage> stage_;      // of the first of them
  std::unique_ptr<SkillStage> other_way_;  // the same, while it gets ready
  Phase phase_;
  bool has_moved_ = false;
  Failure failure_;
};

}  // namespace cell::robot_arm
