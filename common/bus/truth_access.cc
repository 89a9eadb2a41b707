#include "common/bus/truth_access.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cell {
namespace {

struct Reader {
  std::string_view service;
  std::string_view role;
};
constexpr std::array<Reader, 2> kReaders = {{
    {"recorder", "recorder"},     // keeps every channel
    {"tracker", "tracker_ideal"}  // --sensing ideal: stands in for perception
}};

}  // namespace

bool IsTruth(const std::string& channel) {
  return channel.starts_with("TRUTH_");
}

bool MayReadTruth(const std::string& service, const std::string& role) {
  return std::any_of(kReaders.begin(), kReaders.end(), [&](const Reader& r) {
    return r.service == service && r.role == role;
  });
}

}  // namespace cell
