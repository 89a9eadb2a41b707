#include "services/cell/evaluations/row_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace cell::cli {

RowStore::RowStore(std::filesystem::path path, bool is_resumed)
    : path_(std::move(path)) {
  if (path_.has_parent_path()) {
    std::filesystem::create_directories(path_.parent_path());
  }
  constexpr int kHow = O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC;
  file_ = open(path_.c_str(), kHow, 0666);
  if (file_ < 0) {
    Fail(fmt::format("cannot be written: {}", std::strerror(errno)));
  }
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      Fail("another evaluation writes to it; choose another --rows");
    }
    if (!std::filesystem::is_regular_file(path_)) return;
    if (!is_resumed && std::filesystem::file_size(path_) > 0) {
      Fail(
          "already holds rows; continue with --resume, or choose another "
          "--rows");
    }
    Load();
  } catch (...) {
    close(file_);
    throw;
  }
}

RowStore::~RowStore() {
  close(file_);
}

void RowStore::Fail(const std::string& what) const {
  throw std::runtime_error(path_.string() + ": " + what);
}

void RowStore::Load() {
  std::ifstream file(path_, std::ios::binary);
  std::string line;
  off_t num_whole = 0;  // bytes
  for (int number = 1; std::getline(file, line); ++number) {
    const bool is_last = file.eof();  // without an end of line
    const auto row = nlohmann::json::parse(line, nullptr, false);
    if (row.is_object() && row.contains("key") && row["key"].is_string()) {
      rows_[row["key"]] = row;
      num_whole += static_cast<off_t>(line.size()) + 1;
      if (is_last) Write("\n");
    } else if (is_last && line.starts_with('{')) {
      if (ftruncate(file_, num_whole) != 0) Fail(std::strerror(errno));
    } else {
      Fail(
          fmt::format("line {} is not a row of an evaluation; choose another "
                      "--rows",
                      number));
    }
  }
}

void RowStore::Write(const std::string& text) {
  const ssize_t num = write(file_, text.data(), text.size());
  if (num != static_cast<ssize_t>(text.size())) {
    Fail(fmt::format("cannot be written: {}",
                     std::strerror(num < 0 ? errno : ENOSPC)));
  }
}

void RowStore::Append(const std::string& key, const nlohmann::json& row) {
  nlohmann::json keyed = row;
  keyed["key"] = key;
  Write(keyed.dump() + "\n");
  rows_[key] = std::move(keyed);
}

}  // namespace cell::cli
