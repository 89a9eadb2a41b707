#include "services/cell/evaluations/learning_curve.h"

#include <fmt/format.h>

#include <algorithm>

namespace cell::cli {

using nlohmann::json;

RowShape CurveRowShape(int num_tests) {
  return RowShape::Record(
      {{"solved",
        RowShape::ListOf(RowShape::kWhole, static_cast<size_t>(num_tests))}});
}

std::vector<CurvePoint> LearningCurve(const std::vector<json>& rows,
                                      int interval, int num_problems) {
  std::vector<CurvePoint> curve;
  const size_t length = rows.empty() ? 0 : rows[0].at("solved").size();
  for (size_t i = 0; i < length; ++i) {
    CurvePoint point{(static_cast<int>(i) + 1) * interval, 0, 1, 0};
    for (const json& row : rows) {
      const double share = row.at("solved").at(i).get<double>() / num_problems;
      point.mean += share / static_cast<double>(rows.size());
      point.least = std::min(point.least, share);
      point.most = std::max(point.most, share);
    }
    curve.push_back(point);
  }
  return curve;
}

int ActionsToMaster(const json& row, int interval, int num_problems) {
  const auto solved = row.at("solved").get<std::vector<int>>();
  size_t first = solved.size();
  while (first > 0 && solved[first - 1] == num_problems) --first;
  if (first == solved.size()) return -1;
  return (static_cast<int>(first) + 1) * interval;
}

std::string CurveText(const std::vector<CurvePoint>& curve) {
  std::string text = "  actions   solved in the mean   worst run   best run\n";
  for (const CurvePoint& point : curve) {
    text += fmt::format("  {:7} {:18.1f} % {:9.1f} % {:8.1f} %\n",
                        point.num_actions, 100 * point.mean, 100 * point.least,
                        100 * point.most);
  }
  return text;
}

std::string CurveCsv(const std::vector<CurvePoint>& curve) {
  std::string csv = "actions,solved,worst,best\n";
  for (const CurvePoint& point : curve) {
    csv += fmt::format("{},{},{},{}\n", point.num_actions, point.mean,
                       point.least, point.most);
  }
  return csv;
}

std::string CurvePlot(const std::string& csv, const std::string& png) {
  return fmt::format(
      "set terminal pngcairo size 900,600\nset output '{1}'\n"
      "set datafile sep ','\nset xlabel 'actions'\n"
      "set ylabel 'test problems solved (%)'\nset yrange [0:105]\n"
      "set xrange [0:]\nset grid\nset key bottom right\n"
      "plot '{0}' every ::1 using 1:(100*$3):(100*$4) with filledcurves "
      "fc rgb '#c0d0e8' title 'worst to best run', '{0}' every ::1 using "
      "1:(100*$2) with linespoints lc rgb '#204080' title 'mean'\n",
      csv, png);
}

}  // namespace cell::cli
