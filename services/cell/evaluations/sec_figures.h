#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cell::cli {

/// Noise levels p = 0, 0.1 ... 1 of section VI-A.
constexpr size_t kNumNoiseLevels = 11;

/// Mean similarity of a seed with its noisy samples, and its standard error.
struct SecPoint {
  double mean = 0;
  double standard_error = 0;
};

/// A curve of Fig. 13 or 15.
struct SecCurve {
  std::string measure;
  std::string seed;  ///< name
  bool has_flips = false;
  std::array<SecPoint, kNumNoiseLevels> points;
};

/// The figures that can be made: "13", "15a", "15b".
std::vector<std::string> SecFigureNames();

/// The curves of a figure, for the measures `paper` and `derivative`; those of
/// "15b" include those of "15a", which the text compares them with. At each
/// level `num_samples` noisy samples (ChainNoise) are drawn from `seed`.
/// `show` gets the progress. @throws std::invalid_argument for
/// another name.
std::vector<SecCurve> MakeSecCurves(
    const std::string& figure, int num_samples, uint64_t seed,
    const std::function<void(const std::string&)>& show);

/// A line per curve and level: figure, measure, seed, flips, p, samples, mean,
/// standard error.
std::string CurvesToCsv(const std::string& figure, int num_samples,
                        const std::vector<SecCurve>& curves);
/// The program by which gnuplot draws `csv` with error bars into `png`.
std::string CurvesPlot(const std::string& figure, const std::string& csv,
                       const std::string& png,
                       const std::vector<SecCurve>& curves);

/// The largest difference of the curves of `paper` from an independent
/// implementation of the same reading (100 samples per level), in points of
/// 100, and where it is.
struct SecDifference {
  double points = 0;
  std::string where;
};
SecDifference LargestDifference(const std::vector<SecCurve>& curves);

}  // namespace cell::cli
