#pragma once

#include <span>

namespace cell {

/// The bound between low and high similarities by Otsu's method ([83]): the
/// border of the bins of their histogram between 0 and 1 at which
///
///   w_low w_high (mean_low - mean_high)^2
///
/// is largest, w being the shares of the similarities on either side; in the
/// middle of the borders that are equally good. 0 if all are in one bin.
double OtsuCut(std::span<const double> similarities);

/// tau of section VI-A: the mean of the similarities from `cut` on; `cut` if
/// there are none.
double MeanFrom(double cut, std::span<const double> similarities);

}  // namespace cell
