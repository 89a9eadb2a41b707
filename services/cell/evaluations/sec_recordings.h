#pragma once

#include <string>
#include <vector>

#include "common/sec/event_chain.h"

namespace cell::cli {

/// A manipulation that was recorded outside, and what it is.
struct SecRecording {
  std::string name;   ///< of the file, without its extension
  std::string label;  ///< the name up to the last '_'
  EventChain chain;
};

/// Reads tables of relations over time (ChainFromTable). @throws
/// std::invalid_argument naming file and line; std::runtime_error if a file
/// cannot be read.
std::vector<SecRecording> ReadRecordings(const std::vector<std::string>& paths,
                                         double threshold);

/// How one recording is classified by all others.
struct SecLeftOut {
  std::string nearest;  ///< the most similar other recording
  double similarity = 0;
  std::string label;  ///< of `nearest`; empty if others are as similar that
                      ///< have another label
  bool is_right = false;
};

/// Each recording takes the label of the most similar other one. `measure` is a
/// name of ChainSimilarityNames(), or "size" for SizeControl. A tie between
/// labels is not right.
std::vector<SecLeftOut> ClassifyLeaveOneOut(
    const std::vector<SecRecording>& recordings, const std::string& measure);

}  // namespace cell::cli
