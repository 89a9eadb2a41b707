#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

/// The runs of one success rate.
struct RexdGroup {
  double success = 1;
  std::vector<nlohmann::json> rows;
};

struct MeanAndSd {
  double mean = 0;
  double sd = 0;
};

/// Of a count, summed over the episodes from `first` to `last` of each row.
MeanAndSd SummariseCount(const RexdGroup& group, const std::string& count,
                         int first, int last);

/// The table of Fig. 17, for people and as CSV. A row has the lists actions,
/// demonstrations, explorations, reached and dead_ends with a number for each
/// episode; fatal_rules with the true rule of the action that led to a dead
/// end, or -1, and shown_falls with 1 if the teacher did it; states and valid
/// of the frozen rules; probabilities by action [p, experiences].
std::string RexdText(const RexdGroup& group, int num_episodes, double floor);
std::string RexdCsv(const std::vector<RexdGroup>& groups, int num_episodes);

/// Of such a row.
RowShape RexdRowShape(int num_episodes);

/// Commands of gnuplot that draw the CSV as Fig. 17, with error bars of one
/// standard deviation.
std::string RexdPlot(const std::vector<RexdGroup>& groups, int num_episodes,
                     const std::string& csv, const std::string& png);

}  // namespace cell::cli
