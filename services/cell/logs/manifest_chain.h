#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "cell/tick_t.hpp"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// A TICK of a log, verified as far as the log allows.
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
/// of the one before, which verifies all but the last. A damaged one can be
/// rebuilt from its messages, and then be verified; so can several in a row.
/// The last one, and one before a gap, is accepted if it is consistent, and
/// replaced by the rebuilt one if the two differ in a single byte. Pure.
std::map<int32_t, ManifestLink> FindManifests(const LogIndex& index);

}  // namespace cell::cli
