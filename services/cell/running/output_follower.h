#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cell::cli {

/// Reads text files while they are written. Storage adapter.
class OutputFollower {
 public:
  /// The file need not exist yet.
  void Add(const std::filesystem::path& path) { files_.push_back({path, 0}); }

  /// The whole lines that have been added since the last call.
  std::vector<std::string> TakeLines();

 private:
  struct File {
    std::filesystem::path path;
    size_t num_read;  // bytes
  };
  std::vector<File> files_;
};

}  // namespace cell::cli
