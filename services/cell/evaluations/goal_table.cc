#include "services/cell/evaluations/goal_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace cell::cli {

std::string GoalTable(const std::vector<Measure>& measures) {
  std::string table;
  for (const Measure& m : measures) {
    table += fmt::format(
        "{:48} {:>10} {:6.1f} %  {:5.1f} - {:5.1f} %  goal {:3.0f} %: {}\n",
        m.name, fmt::format("{}/{}", m.num_good, m.num_all), 100 * m.value(),
        100 * m.interval().low, 100 * m.interval().high, 100 * m.goal,
        m.verdict());
  }
  return table;
}

bool AreMet(const std::vector<Measure>& measures) {
  return std::ranges::all_of(measures, &Measure::is_met);
}

}  // namespace cell::cli
