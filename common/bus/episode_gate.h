#pragma once

#include <cstdint>
#include <optional>

#include "cell/episode_t.hpp"

namespace cell {

/// What an EPISODE message means to the service that receives it.
enum class EpisodeEvent {
  kBegins,  ///< everything of the episode before is to be forgotten
  kJoins,   ///< an episode runs, and its START has not been received
  kRuns,    ///< the episode that is known goes on
  kEnds
};

/// Follows EPISODE on behalf of a service, which may start, or be restarted,
/// within an episode. Pure.
///
///                  START: kBegins
///                  RUNNING of another id: kJoins
///     no episode ---------------------------------> episode --+
///         ^                                          |   ^    | RUNNING: kRuns
///         +------------------------------------------+   +----+ START: kBegins
///                       END: kEnds
class EpisodeGate {
 public:
  /// Returns nullopt if the message has an unknown phase: it is rejected.
  std::optional<EpisodeEvent> Update(const episode_t& message);

  /// True if `utime` [us] is before the START of the episode: what was measured
  /// then is of the one before. Always false if START has not been received.
  bool IsBefore(int64_t utime) const { return utime < start_utime_; }

 private:
  std::optional<int64_t> id_;  // of the latest episode
  int64_t start_utime_ = 0;
};

}  // namespace cell
