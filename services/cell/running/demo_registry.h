#pragma once

#include <filesystem>
#include <vector>

namespace cell::cli {

/// A `cell demo` of this user that runs now.
struct RunningDemo {
  int pid = 0;
  std::filesystem::path run;  ///< its run folder
};

/// Lets other commands of this user find this process, which runs a demo on a
/// network of its own, as long as this object exists: a file in
/// $XDG_RUNTIME_DIR/cell, or in /tmp/cell-UID where that is not set.
class DemoRegistration {
 public:
  /// @throws std::runtime_error if the file cannot be written.
  explicit DemoRegistration(const std::filesystem::path& run);
  ~DemoRegistration();
  DemoRegistration(const DemoRegistration&) = delete;
  DemoRegistration& operator=(const DemoRegistration&) = delete;

 private:
  std::filesystem::path file_;
};

/// By process id; what a dead process has left behind is passed over.
std::vector<RunningDemo> FindRunningDemos();

}  // namespace cell::cli
