#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/assemblies/annotation.h"
#include "services/cell/scoring/interval.h"

namespace cell::cli {

/// How often each label was given each verdict.
class LabelCounts {
 public:
  using Label = assemblies::Label;

  void Add(Label label, Label verdict, double weight = 1);
  void Add(const LabelCounts& other);
  double At(Label label, Label verdict) const;
  double num_all() const;
  double Accuracy() const;
  /// In [0, 1]; 0 where nothing is to be found.
  double Precision(Label label) const;
  double Recall(Label label) const;
  double F1(Label label) const;
  /// Mean of F1 over correct, mistake and correction.
  double MacroF1() const;

 private:
  double Given(Label verdict) const;
  double Labelled(Label label) const;

  std::array<std::array<double, assemblies::kNumLabels>, assemblies::kNumLabels>
      counts_{};
};

/// 95 % interval of a figure of the summed counts, by 1000 draws of as many
/// groups as there are, with replacement.
Interval BootstrapInterval(
    const std::vector<LabelCounts>& groups,
    const std::function<double(const LabelCounts&)>& figure, uint64_t seed);

}  // namespace cell::cli
