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

using nlohmann::json;

RowStore::RowStore(Params params) : params_(std::move(params)) {
  if (path().has_parent_path()) {
    std::filesystem::create_directories(path().parent_path());
  }
  constexpr int kHow = O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC;
  file_ = open(path().c_str(), kHow, 0666);
  if (file_ < 0) {
    Fail(fmt::format("cannot be written: {}", std::strerror(errno)));
  }
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      Fail("another evaluation writes to it; choose another --rows");
    }
    if (!std::filesystem::is_regular_file(path())) return;
    if (!params_.is_resumed && std::filesystem::file_size(path()) > 0) {
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
  throw std::runtime_error(path().string() + ": " + what);
}

void RowStore::FailAt(const std::string& key, const std::string& what) const {
  Fail(fmt::format(
      "line {}: row '{}': {}; remove the line to make the row anew, or choose "
      "another --rows",
      rows_.at(key).line, key, what));
}

void RowStore::CheckHeader(const std::optional<json>& header) const {
  if (!header) {
    Fail(
        "does not say in its first line what its rows are of (older versions "
        "did not write that); choose another --rows, or leave out --resume and "
        "remove the file");
  }
  const std::string difference = DifferenceFrom(*header, params_.identity);
  if (difference.empty()) return;
  Fail(
      fmt::format("its rows were made otherwise: {}; choose another --rows, "
                  "or leave out --resume and remove the file",
                  difference));
}

void RowStore::Load() {
  std::ifstream file(path(), std::ios::binary);
  std::string line;
  off_t num_whole = 0;   // bytes
  bool is_last = false;  // and without an end of line
  bool is_torn = false;
  std::optional<json> header;
  for (int number = 1; !is_torn && std::getline(file, line); ++number) {
    is_last = file.eof();
    json row = json::parse(line, nullptr, false);
    is_torn = is_last && row.is_discarded() &&
              (number > 1 ? line.starts_with('{') : Header().starts_with(line));
    if (is_torn) continue;
    if (number == 1 && IsRowIdentity(row)) {
      header = std::move(row);
    } else if (row.is_object() && row.contains("key") &&
               row["key"].is_string()) {
      rows_[row["key"]] = {row, number};
    } else {
      Fail(
          fmt::format("line {} is not a row of an evaluation; choose another "
                      "--rows",
                      number));
    }
    num_whole += static_cast<off_t>(line.size()) + 1;
    num_lines_ = number;
  }
  if (num_lines_ > 0) CheckHeader(header);
  for (const auto& [key, entry] : rows_) {
    if (const auto misfit = MisfitOf(entry.row, params_.shape)) {
      FailAt(key, *misfit);
    }
  }
  if (is_torn) {
    if (ftruncate(file_, num_whole) != 0) Fail(std::strerror(errno));
  } else if (is_last) {
    Write("\n");
  }
}

void RowStore::Write(const std::string& text) {
  const ssize_t num = write(file_, text.data(), text.size());
  if (num != static_cast<ssize_t>(text.size())) {
    Fail(fmt::format("cannot be written: {}",
                     std::strerror(num < 0 ? errno : ENOSPC)));
  }
}

void RowStore::Append(const std::string& key, const json& row) {
  json keyed = row;
  keyed["key"] = key;
  if (const auto misfit = MisfitOf(keyed, params_.shape)) {
    Fail(fmt::format("the row '{}' cannot be kept: {}", key, *misfit));
  }
  std::string lines = keyed.dump() + "\n";
  if (num_lines_++ == 0) {
    lines = Header() + "\n" + lines;
    ++num_lines_;
  }
  Write(lines);
  rows_[key] = {std::move(keyed), num_lines_};
}

std::vector<json> RowStore::RowsOf(const std::vector<std::string>& keys) const {
  std::vector<json> rows;
  for (const std::string& key : keys) {
    if (Has(key)) rows.push_back(At(key));
  }
  return rows;
}

}  // namespace cell::cli
