#include "common/bus/truth_access.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cell {
namespace {

constexpr std::array<std::string_view, 3> kReaders = {
    "recorder",       // keeps every channel
    "tracker_ideal",  // --sensing ideal: the tracker's stand-in
    "viewer",         // renders runs and logs
};

}  // namespace

bool IsTruth(const std::string& channel) {
  return channel.starts_with("TRUTH_");
}

bool MayReadTruth(const std::string& service) {
  return std::find(kReaders.begin(), kReaders.end(), service) != kReaders.end();
}

}  // namespace cell
