#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cell/action_t.hpp"
#include "cell/alert_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/truth_action_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/message.h"

namespace cell {

/// What the last episode of a run came to, for scorers and summaries: collected
/// from all its messages. Reads ground truth, so no service may use it.
struct EpisodeRecord {
  std::vector<action_t> actions;
  std::vector<truth_action_t> truth_actions;
  std::vector<alert_t> alerts;
  std::vector<plan_t> plans;
  std::map<int64_t, int64_t> key_frame_utimes;  ///< by index
  std::optional<truth_poses_t> last_poses;
  int64_t last_utime = 0;
  bool has_ended = false;  ///< EPISODE END was heard
};

class EpisodeObserver {
 public:
  /// Messages in canonical order. Those that do not decode are passed over.
  void Put(const Message& message);
  const EpisodeRecord& record() const { return record_; }

 private:
  EpisodeRecord record_;
};

/// The message of type M, or nothing if the bytes are not one.
template <class M>
std::optional<M> Decode(const Message& message) {
  M decoded{};
  const int size = static_cast<int>(message.bytes->size());
  if (decoded.decode(message.bytes->data(), 0, size) != size) {
    return std::nullopt;
  }
  return decoded;
}

}  // namespace cell
