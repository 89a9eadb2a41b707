#pragma once

#include <fmt/format.h>

#include <iostream>
#include <string>

namespace cell {

/// What a benchmark has measured, beside a baseline measured in the same run.
struct Figure {
  std::string name;
  double value = 0;
  std::string unit;
  bool is_more_better = false;
  std::string baseline;  ///< empty: the figure stands for itself
  double baseline_value = 0;
  double goal = 0;  ///< of the ratio, else of the value; 0: none
};

/// The figure as a line of JSON, which scripts/bench reads.
inline void PrintFigure(const Figure& figure) {
  std::string line =
      fmt::format(R"({{"figure": "{}", "value": {}, "unit": "{}", "better": )"
                  R"("{}")",
                  figure.name, figure.value, figure.unit,
                  figure.is_more_better ? "more" : "less");
  if (!figure.baseline.empty()) {
    line += fmt::format(R"(, "baseline": "{}", "baseline_value": {})",
                        figure.baseline, figure.baseline_value);
  }
  if (figure.goal > 0) line += fmt::format(R"(, "goal": {})", figure.goal);
  std::cout << line << "}" << std::endl;
}

}  // namespace cell
