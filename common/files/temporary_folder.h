#pragma once

#include <filesystem>
#include <string>

namespace cell {

/// A new folder for temporary files, gone with this object.
class TemporaryFolder {
 public:
  /// @param purpose  a word of its name: "cell-PURPOSE-..."
  /// @throws std::runtime_error naming the folder that cannot be made, or
  /// TMPDIR.
  explicit TemporaryFolder(const std::string& purpose);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cell
