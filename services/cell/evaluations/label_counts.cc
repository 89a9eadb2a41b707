#include "services/cell/evaluations/label_counts.h"

#include <algorithm>

#include "common/rules/simulation.h"

namespace cell::cli {
namespace {

constexpr int kNumDraws = 1000;
using assemblies::kNumLabels;

size_t IndexOf(assemblies::Label label) {
  return static_cast<size_t>(label);
}

double Ratio(double part, double all) {
  return all > 0 ? part / all : 0;
}

}  // namespace

void LabelCounts::Add(Label label, Label verdict, double weight) {
  counts_[IndexOf(label)][IndexOf(verdict)] += weight;
}

void LabelCounts::Add(const LabelCounts& other) {
  for (size_t i = 0; i < kNumLabels; ++i) {
    for (size_t j = 0; j < kNumLabels; ++j) {
      counts_[i][j] += other.counts_[i][j];
    }
  }
}

double LabelCounts::At(Label label, Label verdict) const {
  return counts_[IndexOf(label)][IndexOf(verdict)];
}

double LabelCounts::Given(Label verdict) const {
  double sum = 0;
  for (const auto& row : counts_) sum += row[IndexOf(verdict)];
  return sum;
}

double LabelCounts::Labelled(Label label) const {
  double sum = 0;
  for (const double count : counts_[IndexOf(label)]) sum += count;
  return sum;
}

double LabelCounts::num_all() const {
  return Labelled(Label::kCorrect) + Labelled(Label::kMistake) +
         Labelled(Label::kCorrection);
}

double LabelCounts::Accuracy() const {
  double good = 0;
  for (size_t i = 0; i < kNumLabels; ++i) good += counts_[i][i];
  return Ratio(good, num_all());
}

double LabelCounts::Precision(Label label) const {
  return Ratio(At(label, label), Given(label));
}

double LabelCounts::Recall(Label label) const {
  return Ratio(At(label, label), Labelled(label));
}

double LabelCounts::F1(Label label) const {
  return Ratio(2 * At(label, label), Given(label) + Labelled(label));
}

double LabelCounts::MacroF1() const {
  return (F1(Label::kCorrect) + F1(Label::kMistake) + F1(Label::kCorrection)) /
         kNumLabels;
}

Interval BootstrapInterval(
    const std::vector<LabelCounts>& groups,
    const std::function<double(const LabelCounts&)>& figure, uint64_t seed) {
  if (groups.empty()) return {};
  rules::RandomNumbers random(seed);
  std::vector<double> figures;
  for (int draw = 0; draw < kNumDraws; ++draw) {
    LabelCounts sum;
    for (size_t i = 0; i < groups.size(); ++i) {
      const int chosen = random.Below(static_cast<int>(groups.size()));
      sum.Add(groups[static_cast<size_t>(chosen)]);
    }
    figures.push_back(figure(sum));
  }
  std::ranges::sort(figures);
  return {figures[kNumDraws / 40], figures[kNumDraws - 1 - kNumDraws / 40]};
}

}  // namespace cell::cli
