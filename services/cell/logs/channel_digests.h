#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cell/tick_t.hpp"

namespace cell::cli {

/// One digest per channel of a run, over all its messages in order, taken from
/// the manifests: two runs are the same exactly if these are.
class ChannelDigests {
 public:
  void Put(const tick_t& manifest);
  /// "CHANNEL 0123456789abcdef", by channel.
  std::vector<std::string> Lines() const;

 private:
  std::map<std::string, uint64_t> digests_;
};

}  // namespace cell::cli
