#include "services/cell/running/process_group.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace cell::cli {
namespace {

// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void BecomeProgram(const char* program, char* const* arguments,
                                int output, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execv(program, arguments);
  _exit(kExitNoProgram);
}

std::string CauseOf(int status) {
  if (WIFSIGNALED(status)) {
    return "killed by signal " + std::to_string(WTERMSIG(status));
  }
  const int code = WEXITSTATUS(status);
  return code == kExitNoProgram ? "the program could not be run"
                                : "exit code " + std::to_string(code);
}

}  // namespace

ProcessGroup::~ProcessGroup() {
  StopAll(0);
}

void ProcessGroup::Start(const std::string& name,
                         const std::filesystem::path& program,
                         const std::vector<std::string>& arguments,
                         const std::filesystem::path& log) {
  const int log_fd =
      open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  Start(name, program, arguments, log_fd);
  if (log_fd >= 0) close(log_fd);
}

void ProcessGroup::Start(const std::string& name,
                         const std::filesystem::path& program,
                         const std::vector<std::string>& arguments,
                         int output) {
  if (access(program.c_str(), X_OK) != 0) {
    throw std::runtime_error(program.string() +
                             ": no such program; build it first");
  }
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), program.string());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) BecomeProgram(program.c_str(), pointers.data(), output, parent);
  if (pid < 0) {
    throw std::runtime_error(program.string() + ": " + std::strerror(errno));
  }
  pids_[name] = pid;
}

void ProcessGroup::Kill(const std::string& name, int signal) {
  const auto it = pids_.find(name);
  if (it != pids_.end()) kill(it->second, signal);
}

std::vector<ProcessGroup::Death> ProcessGroup::TakeDeaths() {
  std::vector<Death> deaths;
  for (auto it = pids_.begin(); it != pids_.end();) {
    int status = 0;
    if (waitpid(it->second, &status, WNOHANG) != it->second) {
      ++it;
      continue;
    }
    const bool is_clean = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    deaths.push_back({it->first, CauseOf(status), is_clean, std::nullopt});
    if (WIFEXITED(status)) deaths.back().exit_code = WEXITSTATUS(status);
    it = pids_.erase(it);
  }
  return deaths;
}

void ProcessGroup::StopAll(int grace_ms) {
  for (const auto& [name, pid] : pids_) kill(pid, SIGTERM);
  constexpr int kStepMs = 10;
  for (int waited = 0; waited < grace_ms && !pids_.empty(); waited += kStepMs) {
    TakeDeaths();
    if (!pids_.empty()) poll(nullptr, 0, kStepMs);
  }
  for (const auto& [name, pid] : pids_) {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }
  pids_.clear();
}

int64_t ProcessGroup::ResidentBytes() const {
  int64_t pages = 0;
  for (const auto& [name, pid] : pids_) {
    std::ifstream statm("/proc/" + std::to_string(pid) + "/statm");
    int64_t total = 0;
    int64_t resident = 0;
    statm >> total >> resident;
    pages += resident;
  }
  return pages * sysconf(_SC_PAGESIZE);
}

}  // namespace cell::cli
