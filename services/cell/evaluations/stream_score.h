#pragma once

#include <map>
#include <string>
#include <vector>

#include "services/cell/evaluations/evaluation.h"
#include "services/cell/evaluations/shown_stream.h"
#include "services/vtb/script.h"

namespace cell::cli {

/// How a stream of demonstrations was recognised.
struct StreamScore {
  int num_actions = 0;  ///< done or undone by the person
  int num_actions_right = 0;
  int num_named = 0;  ///< recognised as an action, done or undone
  int num_named_right = 0;
  int num_reversals = 0;
  int num_reversals_right = 0;
  int num_moves = 0;  ///< manipulations that are no action
  int num_moves_right = 0;
  int num_unknown = 0;  ///< reported as unknown
  int num_unknown_right = 0;
  /// Of what was recognised right, and wrong.
  std::vector<double> confidence_right, confidence_wrong;
  /// One for each that was missed, misread or invented, in plain words.
  std::vector<std::string> errors;
};

/// What the person of demonstrators.yaml calls the placement of each part.
std::map<std::string, std::string> PlacementNames(
    const vtb::Demonstrations& demonstrations, const PartTable& parts);

/// An action is recognised if one of the same part, kind, name and arguments
/// is reported within 1.5 s of the moment the hand let go. A part that was laid
/// down or raised may be an action or unknown.
StreamScore Score(const ShownStream& stream,
                  const std::map<std::string, std::string>& names);

std::vector<Measure> StreamMeasures(const StreamScore& score);

}  // namespace cell::cli
