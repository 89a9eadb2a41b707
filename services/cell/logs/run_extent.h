#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "services/cell/logs/log_index.h"
#include "services/cell/logs/manifest_chain.h"

namespace cell::cli {

/// The first and the last tick of a log of a run. If its first or last TICKs
/// are lost, they follow from messages before and after those that are left.
/// Pure.
class RunExtent {
 public:
  RunExtent() = default;
  RunExtent(const LogIndex& index,
            const std::map<int32_t, ManifestLink>& manifests,
            bool is_canonical);

  /// The first tick that the log holds from its beginning.
  int32_t begin() const { return begin_; }
  /// The last tick with a message in the log.
  int32_t end() const { return end_; }
  /// True if it holds the TICK that is marked as the last one.
  bool is_whole_end() const { return is_whole_end_; }

  /// Channel and sender of all that its TICKs name.
  const std::set<std::pair<std::string, int32_t>>& flows() const {
    return flows_;
  }

  /// True if an entry which TICK `named_in` should name is of the run.
  bool Contains(size_t entry, int32_t named_in) const;
  /// True if an entry that no TICK names is probably the cell's, and of the
  /// tick in its header.
  bool IsTrusted(size_t entry) const;

 private:
  const LogIndex* index_ = nullptr;
  bool is_canonical_ = false;
  std::set<std::pair<std::string, int32_t>> flows_;
  size_t first_place_ = 0;  // entry of the first TICK
  size_t last_place_ = 0;
  int32_t first_tick_ = 0;
  int32_t last_tick_ = 0;
  int32_t begin_ = 0;
  int32_t end_ = 0;
  bool is_whole_end_ = false;
};

}  // namespace cell::cli
