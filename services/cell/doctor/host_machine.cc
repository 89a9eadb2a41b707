#include "services/cell/doctor/host_machine.h"

#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace cell::cli {

namespace fs = std::filesystem;

std::optional<std::string> HostMachine::Read(const std::string& path) const {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) return std::nullopt;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> HostMachine::List(const std::string& path) const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(path, error), end; !error && it != end;
       it.increment(error)) {
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<Machine::Status> HostMachine::StatusOf(
    const std::string& path) const {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return Status{S_ISDIR(status.st_mode), status.st_mode & 07777u,
                status.st_mtime};
}

std::optional<std::string> HostMachine::LinkAt(const std::string& path) const {
  std::error_code error;
  const fs::path target = fs::read_symlink(path, error);
  if (error) return std::nullopt;
  return target.string();
}

std::optional<int64_t> HostMachine::FreeBytes(const std::string& path) const {
  struct statvfs space {};
  if (statvfs(path.c_str(), &space) != 0) return std::nullopt;
  return static_cast<int64_t>(space.f_bavail * space.f_frsize);
}

std::optional<std::string> HostMachine::Environment(
    const std::string& name) const {
  const char* value = std::getenv(name.c_str());
  if (value == nullptr) return std::nullopt;
  return value;
}

int64_t HostMachine::NowSeconds() const {
  return std::time(nullptr);
}

}  // namespace cell::cli
