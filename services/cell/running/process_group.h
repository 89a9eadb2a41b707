#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cell::cli {

/// The exit code of a process if its program could not be run.
inline constexpr int kExitNoProgram = 127;

/// The processes of a cell under one launcher: starts them, reports why they
/// died. They die with the launcher. (systemd is the way to run a cell; this is
/// for demonstrations and tests.) Device adapter.
class ProcessGroup {
 public:
  struct Death {
    std::string name;
    std::string cause;  ///< "killed by signal 9", "exit code 1"
    bool is_clean = false;
    std::optional<int> exit_code;  ///< nothing if a signal killed it
  };

  ProcessGroup() = default;
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ~ProcessGroup();

  /// The output of the process is appended to `log`.
  /// @throws std::runtime_error naming the program if it cannot be started.
  void Start(const std::string& name, const std::filesystem::path& program,
             const std::vector<std::string>& arguments,
             const std::filesystem::path& log);
  /// The same to `output`, which stays open here.
  void Start(const std::string& name, const std::filesystem::path& program,
             const std::vector<std::string>& arguments, int output);
  void Kill(const std::string& name, int signal);
  bool IsRunning(const std::string& name) const { return pids_.contains(name); }
  /// Those that have died since the last call.
  std::vector<Death> TakeDeaths();
  /// SIGTERM to all, SIGKILL to those that are still there after `grace_ms`.
  void StopAll(int grace_ms);

  /// Resident memory of all, as of now.
  int64_t ResidentBytes() const;

 private:
  std::map<std::string, pid_t> pids_;
};

}  // namespace cell::cli
