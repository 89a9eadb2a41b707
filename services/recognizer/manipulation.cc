#include "services/recognizer/manipulation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace cell::recognizer {

Manipulation::Manipulation(const SecLibrary& library, PickUp pick_up)
    : pick_up_(std::move(pick_up)), threshold_(library.threshold()) {
  chain_.Append(before().frame.relations);
  for (const auto direction :
       {ActionDirection::kReversed, ActionDirection::kForward}) {
    for (const auto& model : library.models()) {
      for (auto& roles : model->RolesAtPickUp(part(), before(), direction)) {
        hypotheses_.push_back({model, std::move(roles), direction});
      }
    }
  }
}

std::vector<double> Manipulation::Agreements(const SensedFrame& after) const {
  const ObservedManipulation observed{part(), before(), after, chain_};
  std::vector<double> agreements;
  for (const Hypothesis& hypothesis : hypotheses_) {
    agreements.push_back(hypothesis.model->Agreement(observed, hypothesis.roles,
                                                     hypothesis.direction));
  }
  return agreements;
}

std::vector<Manipulation::Reading> Manipulation::CompletedBy(
    const SensedFrame& after) const {
  const std::vector<double> agreements = Agreements(after);
  std::map<ActionDirection, double> best;
  for (size_t i = 0; i < hypotheses_.size(); ++i) {
    double& of_direction =
        best.try_emplace(hypotheses_[i].direction, threshold_).first->second;
    of_direction = std::max(of_direction, agreements[i]);
  }
  std::vector<Reading> completed;
  for (size_t i = 0; i < hypotheses_.size(); ++i) {
    if (agreements[i] < best.at(hypotheses_[i].direction)) continue;
    completed.push_back({hypotheses_[i], agreements[i]});
  }
  return completed;
}

}  // namespace cell::recognizer
