#include "common/bus/live_state.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const char* what) {
  throw std::runtime_error(
      fmt::format("{}: {}: {}; name a folder that this user can write to with "
                  "--state-dir",
                  path.string(), what, std::strerror(errno)));
}

// Holds the folder's lock as long as it exists.
class Lock {
 public:
  explicit Lock(const std::filesystem::path& path)
      : file_(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (file_ < 0 || flock(file_, LOCK_EX) != 0) Fail(path, "cannot be locked");
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() { close(file_); }

 private:
  int file_;
};

// Whole or not at all, and on disk.
void Replace(const std::filesystem::path& path, const std::string& text) {
  const std::string next = path.string() + ".next";
  const int file =
      open(next.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) Fail(next, "cannot be written");
  const bool is_written = write(file, text.data(), text.size()) ==
                              static_cast<ssize_t>(text.size()) &&
                          fsync(file) == 0;
  const bool is_closed = close(file) == 0;
  if (!is_written || !is_closed) Fail(next, "cannot be written");
  std::filesystem::rename(next, path);
}

}  // namespace

LiveState::LiveState(std::filesystem::path dir) : dir_(std::move(dir)) {
  std::error_code error;
  std::filesystem::create_directories(dir_, error);
  if (error) {
    errno = error.value();
    Fail(dir_, "cannot be made");
  }
}

int64_t LiveState::Epoch(int64_t now_us) const {
  const Lock lock(dir_ / "lock");
  const std::filesystem::path path = dir_ / "epoch";
  std::ifstream file(path);
  int64_t epoch = 0;
  if (file >> epoch && epoch <= now_us) return epoch;
  Replace(path, fmt::format("{}\n", now_us));
  return now_us;
}

int32_t LiveState::NextIncarnation(const std::string& service) const {
  const Lock lock(dir_ / "lock");
  const std::filesystem::path path = dir_ / (service + ".starts");
  int32_t incarnation = 0;
  if (std::ifstream file(path);
      file && (!(file >> incarnation) || incarnation < 0)) {
    throw std::runtime_error(path.string() +
                             ": holds no count of starts; remove it only if no "
                             "log of this cell will be replayed again");
  }
  Replace(path, fmt::format("{}\n", incarnation + 1));
  return incarnation;
}

void LiveState::Forget() const {
  const Lock lock(dir_ / "lock");
  std::filesystem::remove(dir_ / "epoch");
}

void LiveState::CountFrom(int64_t epoch_us) const {
  const Lock lock(dir_ / "lock");
  Replace(dir_ / "epoch", fmt::format("{}\n", epoch_us));
}

}  // namespace cell
