#include "common/files/draft.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path, int error) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}",
                                       path.string(), std::strerror(error)));
}

[[noreturn]] void Refuse(const fs::path& path, std::string_view advice) {
  throw std::runtime_error(
      fmt::format("{}: exists; {}", path.string(), advice));
}

// Resolves symbolic links, so that the links are kept.
fs::path Resolve(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved;
}

// Creates a file beside `target`; the name belongs to the caller alone.
fs::path CreateBeside(const fs::path& target) {
  for (int number = 1;; ++number) {
    const std::string name =
        fmt::format("{}.{}-{}.new", target.string(), getpid(), number);
    const int file =
        open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      close(file);
      return name;
    }
    if (errno != EEXIST) Fail(target, errno);
  }
}

// Some file systems (NFS) know only the second way.
int MoveUnlessThere(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(),
                RENAME_NOREPLACE) == 0) {
    return 0;
  }
  if (errno != EINVAL && errno != ENOSYS) return errno;
  if (link(from.c_str(), to.c_str()) != 0) return errno;
  return unlink(from.c_str()) == 0 ? 0 : errno;
}

void WriteAll(const Draft& draft, const fs::path& path, std::string_view text) {
  const int file = open(draft.path().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (file < 0) Fail(path, errno);
  int error = 0;
  while (!text.empty() && error == 0) {
    const ssize_t num = write(file, text.data(), text.size());
    if (num > 0) text.remove_prefix(static_cast<size_t>(num));
    if (num < 0 && errno != EINTR) error = errno;
  }
  if (close(file) != 0 && error == 0) error = errno;
  if (error != 0) Fail(path, error);
}

}  // namespace

Draft::Draft(fs::path target) : target_(Resolve(std::move(target))) {
  std::error_code error;
  is_direct_ =
      fs::exists(target_, error) && !fs::is_regular_file(target_, error);
  path_ = is_direct_ ? target_ : CreateBeside(target_);
}

Draft::~Draft() {
  if (!is_direct_ && !is_placed_) unlink(path_.c_str());
}

void Draft::Sync() const {
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) Fail(target_, errno);
  const int error = fsync(file) == 0 ? 0 : errno;
  close(file);
  if (error != 0) Fail(target_, error);
}

void Draft::Replace() {
  if (is_direct_) return;
  Sync();
  if (rename(path_.c_str(), target_.c_str()) != 0) Fail(target_, errno);
  is_placed_ = true;
}

void Draft::PutNew(std::string_view advice) {
  if (is_direct_) return;
  Sync();
  const int error = MoveUnlessThere(path_, target_);
  if (error == EEXIST) Refuse(target_, advice);
  if (error != 0) Fail(target_, error);
  is_placed_ = true;
}

void WriteFile(const fs::path& path, std::string_view text) {
  Draft draft(path);
  WriteAll(draft, path, text);
  draft.Replace();
}

void WriteNewFile(const fs::path& path, std::string_view text,
                  std::string_view advice) {
  RequireFree(path, advice);
  Draft draft(path);
  WriteAll(draft, path, text);
  draft.PutNew(advice);
}

void RequireFree(const fs::path& path, std::string_view advice) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) Refuse(path, advice);
  if (fs::is_directory(path, error)) Fail(path, EISDIR);
  if (path.has_parent_path()) MakeFolder(path.parent_path());
  const Draft can_be_created(path);
}

void RequireDistinct(std::initializer_list<fs::path> paths) {
  std::set<fs::path> places;
  for (const fs::path& path : paths) {
    if (path.empty()) continue;
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(path), error);
    if (!places.insert(error ? path : place).second) {
      throw std::runtime_error(path.string() +
                               ": would be written twice; each result needs a "
                               "file of its own");
    }
  }
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  // A link to a folder, and "a/", are no errors.
  std::error_code unknown;
  if (error && !fs::is_directory(folder, unknown)) {
    throw std::runtime_error(fmt::format("{}: cannot be made: {}",
                                         folder.string(), error.message()));
  }
}

}  // namespace cell
