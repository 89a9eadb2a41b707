#pragma once

namespace cell::cli {

struct Interval {
  double low = 0;
  double high = 1;
};

/// Wilson's score interval (95 %) of the rate `num_good` / `num_all`; [0, 1]
/// without trials.
Interval WilsonInterval(int num_good, int num_all);

}  // namespace cell::cli
