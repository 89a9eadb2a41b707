#include "services/cell/evaluations/sec_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

#include "common/sec/chain_noise.h"
#include "common/sec/derivative_similarity.h"
#include "common/sec/paper_similarity.h"
#include "services/cell/evaluations/sec_seeds.h"

namespace cell::cli {
namespace {

double Level(size_t level) {
  return static_cast<double>(level) / (kNumNoiseLevels - 1);
}

SecPoint PointOf(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, n > 1 ? std::sqrt(squares / (n * (n - 1))) : 0};
}

SecCurve MakeCurve(const std::string& name, const MatrixSimilarity& measure,
                   const SecSeed& seed, bool has_flips, int num_samples,
                   uint64_t random_seed) {
  SecCurve curve{name, seed.name, has_flips, {}};
  std::mt19937_64 random(random_seed);
  for (size_t level = 0; level < kNumNoiseLevels; ++level) {
    std::vector<double> values;
    for (int i = 0; i < num_samples; ++i) {
      const auto sample =
          WithNoise(seed.chain, {Level(level), has_flips, {}}, random);
      values.push_back(measure.Between(seed.chain, sample));
    }
    curve.points[level] = PointOf(values);
  }
  return curve;
}

using Means = std::array<int, kNumNoiseLevels>;
using CurveKey = std::pair<std::string, bool>;

const std::map<CurveKey, Means>& IndependentMeans() {
  static const std::map<CurveKey, Means> means = {
      {{"Fig. 12", true}, {100, 77, 66, 55, 45, 42, 36, 34, 33, 31, 30}},
      {{"Fig. 12", false}, {100, 93, 86, 81, 78, 73, 68, 67, 63, 59, 56}},
      {{"I", true}, {100, 82, 64, 53, 43, 39, 36, 34, 33, 30, 31}},
      {{"II", true}, {100, 84, 68, 53, 44, 38, 35, 33, 32, 31, 29}},
      {{"III", true}, {100, 84, 65, 50, 41, 36, 33, 32, 29, 28, 28}},
      {{"IV", true}, {100, 83, 68, 51, 42, 37, 33, 32, 30, 29, 28}},
      {{"I", false}, {100, 93, 86, 81, 75, 71, 67, 63, 59, 57, 54}},
      {{"II", false}, {100, 93, 86, 81, 75, 71, 67, 63, 59, 57, 54}},
      {{"III", false}, {100, 93, 86, 81, 75, 71, 67, 63, 59, 57, 54}},
      {{"IV", false}, {100, 93, 86, 81, 75, 71, 67, 63, 59, 57, 54}}};
  return means;
}

}  // namespace

std::vector<std::string> SecFigureNames() {
  return {"13", "15a", "15b"};
}

std::vector<SecCurve> MakeSecCurves(
    const std::string& figure, int num_samples, uint64_t seed,
    const std::function<void(const std::string&)>& show) {
  if (std::ranges::count(SecFigureNames(), figure) == 0) {
    throw std::invalid_argument("there is no figure '" + figure + "'");
  }
  const PaperSimilarity paper;
  const DerivativeSimilarity derivative;
  const std::pair<std::string, const MatrixSimilarity*> measures[] = {
      {"paper", &paper}, {"derivative", &derivative}};
  RoleTable roles;
  const auto seeds = figure == "13" ? std::vector{Figure12Seed(&roles)}
                                    : Figure14Seeds(&roles);
  std::vector<SecCurve> curves;
  for (const auto& [name, measure] : measures) {
    for (const bool has_flips : {true, false}) {
      if (figure == "15a" && !has_flips) continue;
      for (const SecSeed& sec_seed : seeds) {
        show(fmt::format("curve {}, {}, seed {}", curves.size() + 1, name,
                         sec_seed.name));
        curves.push_back(
            MakeCurve(name, *measure, sec_seed, has_flips, num_samples, seed));
      }
    }
  }
  return curves;
}

std::string CurvesToCsv(const std::string& figure, int num_samples,
                        const std::vector<SecCurve>& curves) {
  std::string text =
      "figure,measure,seed,flips,p,samples,mean,standard_error\n";
  for (const SecCurve& curve : curves) {
    for (size_t level = 0; level < kNumNoiseLevels; ++level) {
      text += fmt::format("{},{},{},{},{:.1f},{},{:.5f},{:.5f}\n", figure,
                          curve.measure, curve.seed, curve.has_flips ? 1 : 0,
                          Level(level), num_samples, curve.points[level].mean,
                          curve.points[level].standard_error);
    }
  }
  return text;
}

std::string CurvesPlot(const std::string& figure, const std::string& csv,
                       const std::string& png,
                       const std::vector<SecCurve>& curves) {
  std::string text = fmt::format(
      "set terminal pngcairo size 960,640\nset output '{}'\n"
      "set datafile sep ','\nset key outside\nset grid\n"
      "set title 'Fig. {}'\nset xlabel 'noise level p'\n"
      "set ylabel 'mean similarity (%)'\nset yrange [0:105]\nplot ",
      png, figure);
  for (size_t i = 0; i < curves.size(); ++i) {
    const SecCurve& curve = curves[i];
    const size_t first = 1 + i * kNumNoiseLevels;
    text += fmt::format(
        "{}'{}' every ::{}::{} using 5:(100*$7):(100*$8) with yerrorlines "
        "title '{} {}{}'",
        i == 0 ? "" : ", ", csv, first, first + kNumNoiseLevels - 1,
        curve.measure, curve.seed, curve.has_flips ? " with flips" : "");
  }
  return text + "\n";
}

SecDifference LargestDifference(const std::vector<SecCurve>& curves) {
  SecDifference largest;
  for (const SecCurve& curve : curves) {
    const auto it = IndependentMeans().find({curve.seed, curve.has_flips});
    if (curve.measure != "paper" || it == IndependentMeans().end()) continue;
    for (size_t level = 0; level < kNumNoiseLevels; ++level) {
      const double points =
          std::abs(100 * curve.points[level].mean - it->second[level]);
      if (points <= largest.points) continue;
      largest = {points, fmt::format("seed {}{}, p = {:.1f}", curve.seed,
                                     curve.has_flips ? " with flips" : "",
                                     Level(level))};
    }
  }
  return largest;
}

}  // namespace cell::cli
