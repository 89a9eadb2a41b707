#include "common/rendering/id_colours.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cell {
namespace {

using Rgb = std::array<uint8_t, 3>;

double LinearOf(uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double LabCurve(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                      : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

Eigen::Vector3d LabOf(const Rgb& colour) {
  const Eigen::Vector3d rgb(LinearOf(colour[0]), LinearOf(colour[1]),
                            LinearOf(colour[2]));
  const Eigen::Matrix3d xyz_of_rgb{{0.4124, 0.3576, 0.1805},
                                   {0.2126, 0.7152, 0.0722},
                                   {0.0193, 0.1192, 0.9505}};
  const Eigen::Vector3d white(0.9505, 1, 1.089);  // D65
  const Eigen::Vector3d xyz = (xyz_of_rgb * rgb).cwiseQuotient(white);
  const double x = LabCurve(xyz[0]), y = LabCurve(xyz[1]), z = LabCurve(xyz[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Every colour of a coarse grid.
std::vector<Rgb> Candidates() {
  constexpr int kSteps = 9;
  const auto level = [](int i) {
    return static_cast<uint8_t>(255 * i / (kSteps - 1));
  };
  std::vector<Rgb> colours;
  for (int r = 0; r < kSteps; ++r) {
    for (int g = 0; g < kSteps; ++g) {
      for (int b = 0; b < kSteps; ++b) {
        colours.push_back({level(r), level(g), level(b)});
      }
    }
  }
  return colours;
}

}  // namespace

double ColourDifference(const Rgb& a, const Rgb& b) {
  return (LabOf(a) - LabOf(b)).norm();
}

std::vector<Rgb> DistinctColours(size_t num) {
  const std::vector<Rgb> candidates = Candidates();
  std::vector<Eigen::Vector3d> labs;
  std::vector<double> nearest;  // of the colours chosen, or black
  for (const Rgb& candidate : candidates) {
    labs.push_back(LabOf(candidate));
    nearest.push_back(ColourDifference(candidate, {0, 0, 0}));
  }
  std::vector<Rgb> chosen;
  while (chosen.size() < num) {
    const size_t best = static_cast<size_t>(std::ranges::max_element(nearest) -
                                            nearest.begin());
    // More bodies than colours: they repeat.
    if (nearest[best] == 0) {
      const size_t num_distinct = chosen.size();
      while (chosen.size() < num) {
        chosen.push_back(chosen[chosen.size() - num_distinct]);
      }
      break;
    }
    chosen.push_back(candidates[best]);
    for (size_t i = 0; i < labs.size(); ++i) {
      nearest[i] = std::min(nearest[i], (labs[i] - labs[best]).norm());
    }
  }
  return chosen;
}

}  // namespace cell
