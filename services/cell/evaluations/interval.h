#pragma once

namespace cell::cli {

struct Interval {
  double low = 0;
  double high = 1;
};

/// Wilson's score interval (95 %) of a rate of which `num_good` of `num_all`
/// trials are known; [0, 1] for none.
Interval WilsonInterval(int num_good, int num_all);

}  // namespace cell::cli
