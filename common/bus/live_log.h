#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "cell/step_t.hpp"
#include "common/bus/manifest.h"
#include "common/bus/message.h"
#include "common/bus/roster.h"

namespace cell {

/// The log of a live cell: its messages, and the journal (STEP) of the messages
/// that each service received in each tick.
class LiveLog {
 public:
  /// Reads DIR/*.lcmlog. @throws std::runtime_error naming the file if there is
  /// none or it holds no STEP.
  static LiveLog Load(const std::filesystem::path& run_dir);
  static LiveLog Load(const std::vector<std::filesystem::path>& logs);
  /// True if the logs hold a STEP, and no TICK before it: a live cell's, not
  /// one in lockstep.
  static bool IsLive(const std::vector<std::filesystem::path>& logs);

  /// The steps of each incarnation, by its sender id, in order of seq.
  const std::map<int32_t, std::vector<step_t>>& incarnations() const {
    return incarnations_;
  }

  /// The message that the journal names, or nullptr.
  const Message* Find(const MessageId& id) const;
  /// True if there is one with this identity, whatever its content.
  bool Has(const std::string& channel, int32_t sender, int32_t seq) const {
    return messages_.contains({channel, sender, seq});
  }
  /// All messages of `sender` except STEPs and forwarded commands, in order.
  std::vector<const Message*> SaidBy(int32_t sender) const;
  /// Every message, by tick, channel, sender and seq.
  std::vector<const Message*> InOrder() const;

  /// What is wrong, in plain words and named by `roster`: damage, messages that
  /// the log or a service lacks. Empty for a whole log of a cell that lost
  /// nothing.
  std::vector<std::string> Problems(const Roster& roster) const;
  /// Messages that an activation got later than in lockstep.
  std::vector<std::string> LateMessages(const Roster& roster) const;

 private:
  using Id = std::tuple<std::string, int32_t, int32_t>;

  void Read(const std::filesystem::path& log);

  std::map<Id, std::vector<Message>> messages_;  // duplicates: one is forged
  std::map<int32_t, std::vector<step_t>> incarnations_;
  std::vector<std::string> corrupt_ranges_;
};

}  // namespace cell
