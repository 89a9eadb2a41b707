#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/cell/logs/log_finding.h"
#include "services/cell/logs/log_index.h"
#include "services/cell/logs/manifest_chain.h"

namespace cell::cli {

/// An event of the canonical log: an entry, or a TICK that was rebuilt.
struct KeptEvent {
  int32_t tick = 0;
  std::string channel;
  int32_t sender = 0;
  int32_t seq = 0;
  std::optional<size_t> entry;
  /// Set for TICKs: without run and nonces.
  std::shared_ptr<const Bytes> bytes;
};

/// The findings of an audit of a cell's log.
struct LogAudit {
  /// Whether it is in the recorder's form: sim stamps, numbered through. Then
  /// every byte is accounted for; other recordings may also hold what a cell's
  /// log does not keep (ACK, HELLO, HEALTH, repeated TICKs, void messages).
  bool is_canonical = false;
  std::map<int32_t, ManifestLink> manifests;  ///< none: a foreign log
  std::vector<LogFinding> findings;           ///< empty: whole
  std::vector<KeptEvent> kept;                ///< in canonical order
  /// True if `kept` is the whole run, from its first TICK to its last: what is
  /// damaged follows from the rest.
  bool is_complete = false;
  /// Messages that no manifest names, of a recording that is not canonical.
  int64_t num_unnamed = 0;
  /// Kept although the TICK that named them is lost.
  int64_t num_unproved = 0;
};

/// Checks a log against its manifests, its own numbers and stamps, and the
/// cell's message types. Names every lost message; where the TICK that named it
/// is lost, too, by the numbers of later ones. If there is no later one,
/// reports after which message more may be missing. Pure.
LogAudit AuditLog(const LogIndex& index);

}  // namespace cell::cli
