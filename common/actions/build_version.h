#pragma once

namespace cell {

/// The version of this build, e.g. "0.1.0": what it learns and stores names it.
const char* BuildVersion();

}  // namespace cell
