#include "common/actions/build_version.h"

namespace cell {

const char* BuildVersion() {
  return CELL_VERSION;
}

}  // namespace cell
