#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/lockstep_node.h"

namespace cell {

/// A service that follows a log of a lockstep run while it is played: the log's
/// TICKs are the clock, and no ACK is sent. Compares its outputs with those of
/// the recorded service and reports the first difference. Pure.
class FollowNode {
 public:
  FollowNode(const Roster& roster, const std::string& name,
             const ServiceFactory& factory,
             std::function<void(const Message&)> send);

  bool Wants(const std::string& channel) const { return node_.Wants(channel); }
  Channels WantedChannels() const { return node_.WantedChannels(); }

  void PutData(Message message) { node_.PutData(std::move(message)); }
  void PutTick(tick_t tick);
  /// Like LockstepNode's.
  bool Advance();
  bool is_done() const { return node_.is_done(); }
  std::optional<std::string> MissingData() const { return node_.MissingData(); }
  int32_t tick() const { return node_.tick(); }

  int64_t num_equal() const { return num_equal_; }
  /// The first tick in which outputs differ from the recorded ones, and how.
  const std::optional<std::string>& difference() const { return difference_; }

 private:
  void Compare(int32_t tick);

  std::string name_;
  size_t index_;
  LockstepNode node_;
  std::map<int32_t, std::vector<Message>> sent_;        // by tick
  std::map<int32_t, std::vector<MessageId>> recorded_;  // by tick
  int64_t num_equal_ = 0;
  std::optional<std::string> difference_;
};

}  // namespace cell
