#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cell::cli {

/// What a diagnosis reads of the machine it runs on.
class Machine {
 public:
  struct Status {
    bool is_folder = false;
    uint32_t mode = 0;    ///< permission bits
    int64_t mtime_s = 0;  ///< [s since 1970]
  };

  Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  virtual ~Machine() = default;

  /// Contents of a file; nothing if it cannot be read.
  virtual std::optional<std::string> Read(const std::string& path) const = 0;
  /// Names in a folder, sorted; none if there is no such folder.
  virtual std::vector<std::string> List(const std::string& path) const = 0;
  virtual std::optional<Status> StatusOf(const std::string& path) const = 0;
  /// What a link points to.
  virtual std::optional<std::string> LinkAt(const std::string& path) const = 0;
  /// [bytes] that an ordinary user may still write there.
  virtual std::optional<int64_t> FreeBytes(const std::string& path) const = 0;
  virtual std::optional<std::string> Environment(
      const std::string& name) const = 0;
  virtual int64_t NowSeconds() const = 0;  ///< [s since 1970]

  bool Exists(const std::string& path) const {
    return StatusOf(path).has_value();
  }
};

}  // namespace cell::cli
