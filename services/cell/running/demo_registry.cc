#include "services/cell/running/demo_registry.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "common/config/decimal.h"
#include "common/files/draft.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kPrefix[] = "demo-";

fs::path RegistryFolder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime != '\0') return fs::path(runtime) / "cell";
  return fmt::format("/tmp/cell-{}", geteuid());
}

/// True if only this user can write there, so that its files can be trusted.
bool IsOwn(const fs::path& folder) {
  struct stat status {};
  return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == geteuid() &&
         (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

/// Tells a process from a later one of the same number: the moment of its
/// start, field 22 of /proc/PID/stat. Empty if it does not run.
std::string StartOf(int pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text;
  std::getline(file, text);
  const size_t name_end = text.rfind(')');  // the name may hold anything
  if (name_end == std::string::npos) return {};
  if (text.compare(name_end, 3, ") Z") == 0) return {};  // has ended
  constexpr int kFieldsBetween = 19;
  size_t at = name_end + 1;
  for (int i = 0; i < kFieldsBetween && at != std::string::npos; ++i) {
    at = text.find(' ', at + 1);
  }
  if (at == std::string::npos) return {};
  return text.substr(at + 1, text.find(' ', at + 1) - at - 1);
}

std::optional<RunningDemo> DemoOf(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kPrefix)) return std::nullopt;
  const auto pid = ParseDecimal<int>(name.substr(sizeof(kPrefix) - 1));
  std::ifstream text(file);
  std::string start, run;
  std::getline(text, start);
  std::getline(text, run);
  if (!pid || start.empty() || start != StartOf(*pid)) return std::nullopt;
  return RunningDemo{*pid, run};
}

}  // namespace

DemoRegistration::DemoRegistration(const fs::path& run)
    : file_(RegistryFolder() / fmt::format("{}{}", kPrefix, getpid())) {
  const fs::path folder = file_.parent_path();
  fs::create_directories(folder.parent_path());
  mkdir(folder.c_str(), S_IRWXU);
  if (!IsOwn(folder)) {
    throw std::runtime_error(folder.string() +
                             ": is not a folder that only this user can write; "
                             "remove it, or set XDG_RUNTIME_DIR");
  }
  WriteFile(file_, fmt::format("{}\n{}\n", StartOf(getpid()),
                               fs::absolute(run).string()));
}

DemoRegistration::~DemoRegistration() {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

std::vector<RunningDemo> FindRunningDemos() {
  const fs::path folder = RegistryFolder();
  std::vector<RunningDemo> demos;
  if (!IsOwn(folder)) return demos;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (auto demo = DemoOf(entry.path())) demos.push_back(*std::move(demo));
  }
  std::ranges::sort(demos, {}, &RunningDemo::pid);
  return demos;
}

}  // namespace cell::cli
