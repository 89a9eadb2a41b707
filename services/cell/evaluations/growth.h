#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/rexd/rexd_task.h"

namespace cell::cli {

/// An assembly of `num_objects` parts, of which each but the first rests on
/// another one, two on each: it can be placed once that one is, and comes to
/// rest in nine of ten cases.
rexd::RexdTask TreeTask(int num_objects);

/// What is measured while a size grows.
struct GrowthSeries {
  std::string name;   ///< what is done
  std::string size;   ///< what grows
  std::string found;  ///< what `result` is, e.g. "expansions"
  struct Point {
    int size = 0;
    double seconds = 0;
    double result = 0;
  };
  std::vector<Point> points;
};

/// Seconds since some time.
using Stopwatch = std::function<double()>;

/// How long something takes at each size; ends after a size that took longer
/// than `most_seconds`.
/// @param measure  does it at one size, and says what it found
GrowthSeries MeasureGrowth(GrowthSeries series, const std::vector<int>& sizes,
                           double most_seconds, const Stopwatch& now,
                           const std::function<double(int)>& measure);

/// Plans from the start of a TreeTask; states whose successors were computed.
double PlanTree(int num_objects, int64_t max_expansions);
/// Learns from so many drawn experiences; the score, eq. (1).
double LearnTree(int num_objects, int num_experiences, uint64_t seed);

std::string GrowthText(const std::vector<GrowthSeries>& all);
std::string GrowthCsv(const std::vector<GrowthSeries>& all);
/// Commands of gnuplot that draw the CSV, both axes logarithmic.
std::string GrowthPlot(const std::vector<GrowthSeries>& all,
                       const std::string& csv, const std::string& png);

}  // namespace cell::cli
