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
constexpr std::array<Reader, 3> kReaders = {{
    {"recorder", "recorder"},      // keeps every channel
    {"tracker", "tracker_ideal"},  // --sensing ideal: stands in for perception
    {"camera_set", "camera_renderer"}  // draws what a real camera would see
}};

}  // namespace

bool IsTruth(const std::string& channel) {
  return channel.starts_with("TRUTH_");
}

bool MayReadTruth(const std::string& service, const std::string& role) {
  const std::string program = service.substr(0, service.find('@'));
  return std::any_of(kReaders.begin(), kReaders.end(), [&](const Reader& r) {
    return r.service == program && r.role == role;
  });
}

}  // namespace cell
