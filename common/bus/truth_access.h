#pragma once

#include <string>

namespace cell {

/// True for the testbed's ground truth, TRUTH_*.
bool IsTruth(const std::string& channel);

/// The one list of services that may read ground truth: the tracker while it
/// simulates perfect sensing, cameras that render their images, and the
/// recorder. No estimator.
/// @param service  as in the roster, of any instance
/// @param role  what the service is at present, as in the roster
bool MayReadTruth(const std::string& service, const std::string& role);

}  // namespace cell
