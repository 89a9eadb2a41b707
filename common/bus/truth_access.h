#pragma once

#include <string>

namespace cell {

/// True for the testbed's ground truth, TRUTH_*.
bool IsTruth(const std::string& channel);

/// The one list of who may read ground truth: the tracker while it stands in
/// for perfect sensing, the recorder and viewers. Nobody who estimates.
bool MayReadTruth(const std::string& service);

}  // namespace cell
