#include "services/cell/logs/stock_reader.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <lcm/lcm-cpp.hpp>
#include <system_error>

namespace cell::cli {
namespace {

void Require(bool is_done, const char* step) {
  if (!is_done) throw std::system_error(errno, std::generic_category(), step);
}

// Writes the number of events so far after each event.
[[noreturn]] void ReadInChild(const std::filesystem::path& log, int out) {
  // No event is longer than the file.
  const rlim_t size = (rlim_t{1} << 30) + std::filesystem::file_size(log);
  const rlimit memory{size, size};
  setrlimit(RLIMIT_AS, &memory);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  int64_t num = 0;
  try {
    lcm::LogFile file(log.string(), "r");
    while (file.good() && file.readNextEvent() != nullptr) {
      ++num;
      if (write(out, &num, sizeof(num)) != sizeof(num)) _exit(1);
    }
  } catch (const std::exception&) {
    _exit(1);
  }
  _exit(0);
}

}  // namespace

StockReading ReadAsStockToolsDo(const std::filesystem::path& log) {
  std::array<int, 2> ends{};
  Require(pipe(ends.data()) == 0, "opening a pipe");
  const pid_t child = fork();
  Require(child >= 0, "starting a process");
  if (child == 0) {
    close(ends[0]);
    close(STDERR_FILENO);
    ReadInChild(log, ends[1]);
  }
  close(ends[1]);
  StockReading reading;
  int64_t num = 0;
  while (read(ends[0], &num, sizeof(num)) == sizeof(num)) {
    reading.num_events = num;
  }
  close(ends[0]);
  int status = 0;
  Require(waitpid(child, &status, 0) == child, "awaiting a process");
  if (WIFSIGNALED(status)) {
    reading.end = fmt::format("killed by signal {}", WTERMSIG(status));
  } else if (WEXITSTATUS(status) != 0) {
    reading.end = "failed";
  } else {
    reading.end = "says that the log ends";
  }
  return reading;
}

}  // namespace cell::cli
