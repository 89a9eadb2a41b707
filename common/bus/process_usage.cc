#include "common/bus/process_usage.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace cell {

ProcessUsage UsageOfThisProcess() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto micros = [](const timeval& time) {
    return int64_t{time.tv_sec} * 1'000'000 + time.tv_usec;
  };
  std::ifstream statm("/proc/self/statm");
  int64_t total_pages = 0;
  int64_t resident_pages = 0;
  statm >> total_pages >> resident_pages;
  return {micros(usage.ru_utime) + micros(usage.ru_stime),
          resident_pages * sysconf(_SC_PAGESIZE)};
}

}  // namespace cell
