#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/planner/monitor.h"

namespace cell {

/// Changes of the state that no recognised action accounts for: whoever sees
/// and names what people do was dead meanwhile, or it happened by itself. The
/// plan is right all the same, since it is made from the state. Pure.
class UnseenChanges {
 public:
  struct Params {
    /// [us] An action has a name by then: it ends when the hand lets go.
    int64_t patience_us = 15'000'000;
    /// [us] A change so long after an action's end is its doing.
    int64_t settle_us = 2'000'000;
  };

  UnseenChanges(const Domain& domain, const Params& params)
      : domain_(domain), params_(params) {}

  void Take(const SensedState& sensed);
  void Take(const DoneAction& action);

  /// What has waited long enough for an action, in plain words, once.
  std::vector<std::string> TakeOverdue(int64_t now);

 private:
  struct Change {
    int64_t key_frame = 0;
    int64_t utime = 0;
    std::vector<std::pair<int, bool>> atoms;  // and what they have become
  };

  bool Explains(const DoneAction& action, const Change& change) const;
  std::string Tell(const Change& change) const;

  const Domain& domain_;
  Params params_;
  std::optional<SensedState> latest_;
  std::vector<Change> changes_;     // not accounted for yet
  std::deque<DoneAction> actions_;  // the latest ones
};

}  // namespace cell
