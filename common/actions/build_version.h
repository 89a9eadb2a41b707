#pragma once

namespace cell {

/// The version of this build, e.g. "0.1.0", kept with all it learns and stores.
const char* BuildVersion();

}  // namespace cell
