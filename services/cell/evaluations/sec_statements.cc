#include "services/cell/evaluations/sec_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cell::cli {
namespace {

// "Around" a number of percent.
constexpr double kAround = 5;
// The paper's threshold of type-similar actions, in percent.
constexpr double kSimilar = 64;

// Means in percent, of all seeds at one level.
class Curves {
 public:
  Curves(const std::vector<SecCurve>& all, const std::string& measure,
         bool has_flips) {
    for (const SecCurve& curve : all) {
      if (curve.measure == measure && curve.has_flips == has_flips) {
        curves_.push_back(&curve);
      }
    }
  }

  std::vector<double> At(size_t level) const {
    std::vector<double> means;
    for (const SecCurve* curve : curves_) {
      means.push_back(100 * curve->points[level].mean);
    }
    return means;
  }
  double Least(size_t level) const { return std::ranges::min(At(level)); }
  double Most(size_t level) const { return std::ranges::max(At(level)); }
  double Spread() const {
    double spread = 0;
    for (size_t level = 0; level < kNumNoiseLevels; ++level) {
      spread = std::max(spread, Most(level) - Least(level));
    }
    return spread;
  }

 private:
  std::vector<const SecCurve*> curves_;
};

// The least lead of `a` over `b` at a level with noise.
double LeastLead(const Curves& a, const Curves& b) {
  double lead = 100;
  for (size_t level = 1; level < kNumNoiseLevels; ++level) {
    lead = std::min(lead, a.Least(level) - b.Most(level));
  }
  return lead;
}

bool IsAround(double value, double stated) {
  return std::abs(value - stated) <= kAround;
}

std::vector<SecStatement> OnFigure13(const Curves& red, const Curves& blue) {
  const double early = (red.Least(0) - red.Least(5)) / 5;
  const double late = (red.Least(5) - red.Least(10)) / 5;
  double tail = 0;
  for (size_t level = 6; level <= 10; ++level) tail += red.Least(level) / 5;
  return {
      {"at p = 0 sample and seed are identical", "both curves at 100",
       fmt::format("{:.0f} and {:.0f}", red.Least(0), blue.Least(0)),
       red.Least(0) == 100 && blue.Least(0) == 100},
      {"the slope of the red curve changes around p = 0.5",
       "at least twice as steep before as after",
       fmt::format("{:.1f} and {:.1f} per level", early, late),
       early >= 2 * late},
      {"after that the red curve is around 30",
       "mean of p = 0.6 to 1 within 5 of 30", fmt::format("{:.1f}", tail),
       IsAround(tail, 30)},
      {"the blue curve is still around 70 at p = 0.8", "within 5 of 70",
       fmt::format("{:.1f}", blue.Least(8)), IsAround(blue.Least(8), 70)},
      {"the red curve is that high at p = 0.2", "within 5 of 70",
       fmt::format("{:.1f}", red.Least(2)), IsAround(red.Least(2), 70)},
      {"... and only there", "below 65 from p = 0.3 on",
       fmt::format("{:.1f} at 0.3", red.Most(3)), red.Most(3) < 70 - kAround},
      {"noisy rows and columns alone do not affect it significantly; flipped "
       "entries do",
       "blue above red at every p > 0",
       fmt::format("least lead {:.1f}", LeastLead(blue, red)),
       LeastLead(blue, red) > 0}};
}

std::vector<SecStatement> OnFigure15a(const Curves& flips) {
  return {{"the four curves behave alike, whatever the size",
           "at most 10 apart at every p",
           fmt::format("{:.1f} apart", flips.Spread()), flips.Spread() <= 10},
          {"actions can be classified up to a noise of 0.2",
           "all seeds at least 64 at p = 0.2",
           fmt::format("{:.1f} to {:.1f}", flips.Least(2), flips.Most(2)),
           flips.Least(2) >= kSimilar},
          {"... and not above", "all seeds below 64 at p = 0.3",
           fmt::format("{:.1f} to {:.1f}", flips.Least(3), flips.Most(3)),
           flips.Most(3) < kSimilar}};
}

std::vector<SecStatement> OnFigure15b(const Curves& flips,
                                      const Curves& no_flips) {
  const double lead = LeastLead(no_flips, flips);
  return {{"classification is still applicable around a noise of 0.6",
           "mean of the seeds at least 64 - 5 at p = 0.6",
           fmt::format("{:.1f} to {:.1f}", no_flips.Least(6), no_flips.Most(6)),
           no_flips.Least(6) >= kSimilar - kAround},
          {"that is much better than with flipped entries",
           "every seed above every one of Fig. 15a at every p > 0",
           fmt::format("least lead {:.1f}", lead), lead > 0}};
}

}  // namespace

std::vector<SecStatement> CheckStatements(const std::string& figure,
                                          const std::string& measure,
                                          const std::vector<SecCurve>& curves) {
  const Curves flips(curves, measure, true);
  if (figure == "15a") return OnFigure15a(flips);
  const Curves no_flips(curves, measure, false);
  return figure == "13" ? OnFigure13(flips, no_flips)
                        : OnFigure15b(flips, no_flips);
}

}  // namespace cell::cli
