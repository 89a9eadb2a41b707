#include "common/recordings/recording_file.h"

#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "common/recordings/recording_text.h"

namespace cell {
namespace {

constexpr std::uintmax_t kMaxBytes = 64 << 20;

}  // namespace

Recording LoadRecording(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw RecordingError(name + ": " + error.message());
  if (size > kMaxBytes) {
    throw RecordingError(name + ": larger than 64 MiB, no recording");
  }
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) throw RecordingError(name + ": cannot be read");
  return RecordingFromText(text.view(), name);
}

}  // namespace cell
