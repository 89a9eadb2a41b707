#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/relational/state.h"
#include "common/relational/vocabulary.h"

namespace cell::planner {

/// What an arm says of itself. Objects are the vocabulary's.
struct ArmStatus {
  static constexpr int64_t kIdle = -1;
  int arm = 0;
  int64_t utime = 0;        ///< [us]
  int64_t request = kIdle;  ///< id of the skill that runs
  std::optional<int> held;
  std::vector<int> reachable;  ///< parts that it could take where they lie
};

/// The latest reports of all arms of a domain: the arguments of its reported
/// predicates.
class Arms {
 public:
  /// `vocabulary` must outlive this object.
  explicit Arms(const Vocabulary& vocabulary);

  const std::vector<int>& arms() const { return arms_; }
  void Take(const ArmStatus& report);
  /// Nothing until it has reported.
  const ArmStatus* Of(int arm) const;
  /// Every arm has reported at this time or later.
  bool HaveReportedSince(int64_t utime) const;
  bool AreIdle() const;

  /// The state with the reported predicates as they are now; unknown of an arm
  /// that has not reported. What an arm holds it can reach, the others cannot.
  State WithReports(State state) const;

 private:
  Truth IsHeld(int part, int arm) const;
  Truth IsReachable(int arm, int part) const;

  const Vocabulary& vocabulary_;
  std::vector<int> arms_;  // ascending
  std::map<int, ArmStatus> reports_;
};

/// The state in which no arm holds or reaches anything: for who watches a
/// person.
State WithoutArms(State state, const Vocabulary& vocabulary);

}  // namespace cell::planner
