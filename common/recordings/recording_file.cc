#include "common/recordings/recording_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "common/recordings/recording_text.h"

namespace cell {
namespace {

constexpr std::uintmax_t kMaxBytes = 64 << 20;

}  // namespace

std::vector<std::filesystem::path> RecordingsIn(
    const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == kRecordingExtension) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

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
