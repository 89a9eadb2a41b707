#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "common/bus/message.h"

namespace cell {

/// Decides which messages of a live cell are new, by sender and seq, and counts
/// those that were lost. Bytes from the bus are not trusted: a forged seq must
/// neither block the true ones nor make this grow without bound. Pure.
class Arrivals {
 public:
  /// `num_services` in the roster: other senders are unknown.
  explicit Arrivals(size_t num_services) : num_services_(num_services) {}

  /// Returns true if `message` is to be handled: the next of its sender on its
  /// channel, one that was skipped, or the first of a new incarnation. A far
  /// jump is accepted once a second message follows it.
  bool Accept(const Message& message);

  /// Messages that never came, by channel.
  const std::map<std::string, int64_t>& num_lost() const { return num_lost_; }
  int64_t num_repeated() const { return num_repeated_; }
  int64_t num_unknown_senders() const { return num_unknown_senders_; }

 private:
  /// A jump of more is not a loss but a forgery or a long absence.
  static constexpr int32_t kMaxJump = 1000;
  static constexpr size_t kMaxFlows = 4096;

  struct Flow {
    int32_t sender = 0;
    int32_t seq = 0;            // the highest one
    std::set<int32_t> skipped;  // below it, at most kMaxJump
    std::optional<std::pair<int32_t, int32_t>> doubtful;  // sender, seq
  };

  bool Follows(const Message& message, Flow* flow);

  size_t num_services_;
  /// By channel and index in the roster.
  std::map<std::pair<std::string, size_t>, Flow> flows_;
  std::map<std::string, int64_t> num_lost_;
  int64_t num_repeated_ = 0;
  int64_t num_unknown_senders_ = 0;
};

}  // namespace cell
