#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

/// How many test problems are solved with what was learned after so many
/// actions, over all runs.
struct CurvePoint {
  int num_actions = 0;
  double mean = 0;  ///< share of the problems
  double least = 0;
  double most = 0;
};

/// Of a row with this many tests.
RowShape CurveRowShape(int num_tests);

/// @param rows  of a run each: "solved", numbers of problems, one for every
///     `interval` actions; equally many in all rows
std::vector<CurvePoint> LearningCurve(const std::vector<nlohmann::json>& rows,
                                      int interval, int num_problems);

/// Actions after which the run solves all problems, and does so ever after;
/// -1 if it never does.
int ActionsToMaster(const nlohmann::json& row, int interval, int num_problems);

std::string CurveText(const std::vector<CurvePoint>& curve);
std::string CurveCsv(const std::vector<CurvePoint>& curve);
/// Commands of gnuplot that draw the CSV.
std::string CurvePlot(const std::string& csv, const std::string& png);

}  // namespace cell::cli
