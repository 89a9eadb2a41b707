#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace cell::camera_set {

/// @throws std::runtime_error that names the file.
[[noreturn]] inline void FailFile(const std::filesystem::path& path,
                                  const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

}  // namespace cell::camera_set
