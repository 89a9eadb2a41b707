#pragma once

#include <vector>

#include "services/cell/doctor/check.h"

namespace cell::cli {

/// What is installed: configuration, programs, message types, packages, Java.
std::vector<Check> SoftwareChecks();

}  // namespace cell::cli
