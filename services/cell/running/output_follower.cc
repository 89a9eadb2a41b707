#include "services/cell/running/output_follower.h"

#include <fstream>

namespace cell::cli {

std::vector<std::string> OutputFollower::TakeLines() {
  std::vector<std::string> lines;
  for (File& file : files_) {
    std::error_code no_file;
    const auto size = std::filesystem::file_size(file.path, no_file);
    if (no_file || size <= file.num_read) continue;
    std::ifstream stream(file.path);
    stream.seekg(static_cast<std::streamoff>(file.num_read));
    std::string line;
    while (std::getline(stream, line) && !stream.eof()) {
      file.num_read += line.size() + 1;
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace cell::cli
