#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/relational/state.h"
#include "common/relational/vocabulary.h"

namespace cell::planner {

/// What an arm reports of one of its skills.
struct SkillTraits {
  bool may_run_beside = false;  ///< while another arm is at work
  /// Brings the part to where another arm can take it: before its turn, too.
  bool hands_over = false;
};

/// What an arm reports of itself. Objects are indices of the vocabulary.
struct ArmState {
  static constexpr int64_t kIdle = -1;
  int arm = 0;
  int64_t utime = 0;        ///< [us]
  int64_t request = kIdle;  ///< id of the skill that runs
  std::optional<int> held;
  std::vector<int> reachable;  ///< parts that it could take where they lie
  std::map<std::string, SkillTraits> skills = {};  ///< by name
};

/// The latest reports of all arms of a domain: the arguments of its reported
/// predicates.
class ArmStates {
 public:
  explicit ArmStates(std::shared_ptr<const Vocabulary> vocabulary);

  const std::vector<int>& arms() const { return arms_; }
  void Update(const ArmState& report);
  /// Nullptr until it has reported.
  const ArmState* Of(int arm) const;
  /// Nullptr if the arm has not reported such a skill.
  const SkillTraits* TraitsOf(int arm, const std::string& skill) const;
  /// Every arm has reported at this time or later.
  bool HaveReportedSince(int64_t utime) const;
  bool AreIdle() const;

  /// The state with the reported predicates as they are now; unknown of an arm
  /// that has not reported. What an arm holds it can reach, the others cannot.
  State WithReports(State state) const;

 private:
  Truth IsHeld(int part, int arm) const;
  Truth IsReachable(int arm, int part) const;

  std::shared_ptr<const Vocabulary> vocabulary_;
  std::vector<int> arms_;  // ascending
  std::map<int, ArmState> reports_;
};

/// The state in which no arm holds or reaches anything, as while a person
/// assembles.
State WithoutArms(State state, const Vocabulary& vocabulary);

}  // namespace cell::planner
