#include "services/recognizer/manipulation.h"

#include <algorithm>
#include <map>
#include <utility>

namespace cell::recognizer {

namespace {

bool IsSame(const Manipulation::Hypothesis& a,
            const Manipulation::Hypothesis& b) {
  return a.model == b.model && a.roles == b.roles && a.direction == b.direction;
}

}  // namespace

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
  std::vector<bool> is_completed(hypotheses_.size(), false);
  for (size_t i = 0; i < hypotheses_.size(); ++i) {
    if (agreements[i] < best.at(hypotheses_[i].direction)) continue;
    completed.push_back({hypotheses_[i], agreements[i], 0});
    is_completed[i] = true;
  }
  for (Reading& reading : completed) {
    double next = 0;
    for (size_t i = 0; i < hypotheses_.size(); ++i) {
      // Undone and done may hold together; two of one direction may not.
      const bool may_hold_too =
          is_completed[i] &&
          (hypotheses_[i].direction != reading.hypothesis.direction ||
           IsSame(hypotheses_[i], reading.hypothesis));
      if (!may_hold_too) next = std::max(next, agreements[i]);
    }
    reading.confidence = std::max(0.0, reading.agreement - next / 2);
  }
  return completed;
}

double Manipulation::ConfidenceInNone(const SensedFrame& after) const {
  double best = 0;
  for (const double agreement : Agreements(after)) {
    best = std::max(best, agreement);
  }
  return 1 - best;
}

}  // namespace cell::recognizer
