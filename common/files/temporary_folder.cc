#include "common/files/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace cell {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder(const std::string& purpose) {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  if (error) {
    throw std::runtime_error(
        "TMPDIR: should be the folder for temporary files: " + error.message());
  }
  std::string name = (parent / ("cell-" + purpose + "-XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error(name +
                             ": cannot be made: " + std::strerror(errno));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // what remains is among temporary files
  fs::remove_all(path_, ignored);
}

}  // namespace cell
