#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "services/cell/logs/log_finding.h"

namespace cell::cli {

/// Finds lost messages when their TICK is lost, too: each sender numbers its
/// messages on a channel from 0 on, without gaps. Pure.
class SequenceGaps {
 public:
  /// A message that the log holds, or that one of its TICKs names.
  void Put(const std::string& channel, int32_t sender, int32_t seq,
           int32_t tick);
  /// A sender without messages before `tick`.
  void PutBirth(int32_t sender, int32_t tick) { births_[sender] = tick; }
  /// A sender without messages from `tick` on.
  void PutDeath(int32_t sender, int32_t tick) { deaths_[sender] = tick; }
  bool IsDeadIn(int32_t sender, int32_t tick) const;

  /// One finding for each message that is not known, but a later one is.
  std::vector<LogFinding> Find() const;
  /// Sequences that may have ended in the TICKs `first` to `last`, by their
  /// last known message, as "CHANNEL sender 2 seq 20".
  std::vector<std::string> EndsIn(int32_t first, int32_t last) const;
  /// Sequences that may have begun in or before the TICKs up to `last`, by
  /// their first known message.
  std::vector<std::string> BeginningsUpTo(int32_t last) const;

 private:
  struct Place {
    int32_t seq = 0;
    int32_t tick = 0;
    bool operator<(const Place& other) const { return seq < other.seq; }
  };
  using Flow = std::pair<std::string, int32_t>;  // channel, sender

  std::map<Flow, std::vector<Place>> flows_;
  std::map<int32_t, int32_t> births_;  // sender -> tick
  std::map<int32_t, int32_t> deaths_;
};

}  // namespace cell::cli
