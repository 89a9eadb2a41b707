#pragma once

#include <string>

namespace cell {

/// True for the testbed's ground truth, TRUTH_*.
bool IsTruth(const std::string& channel);

/// The one list of who may read ground truth: the tracker while it stands in
/// for perfect sensing, cameras that draw what they would see, and the
/// recorder. Nobody who estimates.
/// @param service  as in the roster, of any instance
/// @param role  what the service is at present, as in the roster
bool MayReadTruth(const std::string& service, const std::string& role);

}  // namespace cell
