#include "services/recognizer/manipulation.h"

#include <algorithm>
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

std::vector<Manipulation::Hypothesis> Manipulation::CompletedBy(
    const SensedFrame& after) const {
  const ObservedManipulation observed{part(), before(), after, chain_};
  std::vector<Hypothesis> completed;
  double best = threshold_;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const double agreement = hypothesis.model->Agreement(
        observed, hypothesis.roles, hypothesis.direction);
    if (agreement < best) continue;
    if (agreement > best) completed.clear();
    best = agreement;
    completed.push_back(hypothesis);
  }
  return completed;
}

}  // namespace cell::recognizer
