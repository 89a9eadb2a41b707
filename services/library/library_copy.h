#pragma once

#include <filesystem>

#include "common/files/temporary_folder.h"

namespace cell::library {

/// A copy of a library's file, with what its journal (-wal) holds, in a
/// temporary folder of its own as long as this object exists: SQLite reads no
/// file in a folder where it cannot write. Storage adapter.
class LibraryCopy {
 public:
  /// True if this user may write the file and the folder that it is in.
  static bool IsWritable(const std::filesystem::path& file);

  /// @throws std::runtime_error naming the file that cannot be read, or that
  /// another process owns.
  explicit LibraryCopy(const std::filesystem::path& file);

  const std::filesystem::path& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

}  // namespace cell::library
