#pragma once

#include <filesystem>

#include "services/cell/logs/log_audit.h"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// Writes what an audit keeps, in the recorder's form: by tick, channel,
/// sender, seq, with sim stamps, TICKs without run and nonces. Of a log without
/// TICKs: all whole events, unchanged.
/// @return how many events. @throws std::runtime_error naming the file if it
/// exists or cannot be written.
int64_t WriteCanonicalLog(const LogIndex& index, const LogAudit& audit,
                          const std::filesystem::path& out);

}  // namespace cell::cli
