#include "services/library/library_copy.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "services/library/action_store.h"

namespace cell::library {
namespace {

namespace fs = std::filesystem;

/// Where SQLite's processes lock a database (its PENDING_BYTE and after).
constexpr off_t kFirstLock = 0x40000000;
constexpr off_t kNumLocks = 512;

[[noreturn]] void Fail(const fs::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

[[noreturn]] void FailAsSystem(const fs::path& file, int error) {
  Fail(file, std::string("cannot be read: ") + std::strerror(error));
}

void RequireNoOwner(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) FailAsSystem(file, errno);
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = kFirstLock;
  lock.l_len = kNumLocks;
  const bool is_owned =
      fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  close(descriptor);
  if (is_owned) Fail(file, kOwnedByAnother);
}

void CopyInto(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, error);
  if (error) FailAsSystem(from, error.value());
}

}  // namespace

bool LibraryCopy::IsWritable(const fs::path& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  return access(file.c_str(), W_OK) == 0 && access(folder.c_str(), W_OK) == 0;
}

LibraryCopy::LibraryCopy(const fs::path& file) : folder_("library") {
  RequireNoOwner(file);
  path_ = folder_.path() / file.filename();
  CopyInto(file, path_);
  const fs::path journal = file.string() + "-wal";
  if (fs::exists(journal)) CopyInto(journal, path_.string() + "-wal");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace cell::library
