#pragma once

#include <memory>
#include <optional>
#include <string>

#include "services/robot_arm/arm_reading.h"

namespace cell::robot_arm {

/// Why a stage, or the skill that it is of, cannot go on.
struct Failure {
  enum class Cause { kOther, kPersonInTheWay };
  std::string reason;  ///< in plain words
  Cause cause = Cause::kOther;

  static Failure PersonInTheWay() {
    return {"a person's hand is in the way", Cause::kPersonInTheWay};
  }
};

/// One stretch of a skill that runs tick by tick: a motion, the fingers, a
/// contact. It changes the command and returns whether it is over. It is not
/// called while the arm is frozen; `dt` [s] excludes the time that it was.
class SkillStage {
 public:
  enum class State {
    kWaiting,  ///< nothing moves yet
    kRunning,
    kDone,
    kFailed
  };

  SkillStage() = default;
  SkillStage(const SkillStage&) = delete;
  SkillStage& operator=(const SkillStage&) = delete;
  virtual ~SkillStage() = default;
  virtual State Step(const ArmReading& reading, double dt,
                     ArmCommand* command) = 0;
  /// Where the joints will be in `seconds` if nothing hinders it; nothing if
  /// they stay about where they are. `q`: the command now.
  virtual std::optional<Joints> Ahead(double /*seconds*/,
                                      const Joints& /*q*/) const {
    return std::nullopt;
  }
  /// True if it can be made again on its way, from where it is then.
  virtual bool HasOtherWays() const { return false; }
  /// Gets ready before its first step: kWaiting until it is, then kRunning, or
  /// kFailed. `dt` [s] have passed.
  virtual State Prepare(double /*dt*/) { return State::kRunning; }
  /// Why it has failed.
  virtual Failure failure() const { return {}; }
};

}  // namespace cell::robot_arm
