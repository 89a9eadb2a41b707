#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "cell/tick_t.hpp"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// A TICK of a log that can be believed as far as the log allows.
struct ManifestLink {
  tick_t tick{};
  Message message;  ///< its canonical form
  /// Which entry it is; none if it was damaged and has been rebuilt, to the
  /// byte, from the messages that it named.
  std::optional<size_t> entry;
  /// The TICK after it, or the messages that it names, confirm every byte.
  bool is_proved = false;
};

/// Finds the manifests of a run in a damaged log. Each TICK carries the digest
/// of the one before: so all but the last are beyond doubt, whatever a log
/// offers, and one that is damaged can be guessed from its messages, and the
/// guess be proved; so can several in a row. The last one, and one before a
/// gap, is believed if it is sound, and taken as guessed if it differs from
/// that in a single byte. Pure.
std::map<int32_t, ManifestLink> FindManifests(const LogIndex& index);

}  // namespace cell::cli
