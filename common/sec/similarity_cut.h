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

/// The highest bound between groups of similarities: Otsu's, and as long as
/// those above it are two groups themselves, theirs. They are if the bound
/// explains most of their variance, and their means are 0.05 apart:
///
///   w_low w_high (mean_low - mean_high)^2 >= 0.8 variance
///
/// (it explains 2/pi of a normal distribution, 3/4 of an even one). So
/// manipulations that are alike in part are not taken for the same.
double HighestCut(std::span<const double> similarities);

/// tau of section VI-A: the mean of the similarities from `cut` on; `cut` if
/// there are none.
double MeanFrom(double cut, std::span<const double> similarities);

}  // namespace cell
