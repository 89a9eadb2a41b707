#include "common/planning/model.h"

namespace cell::planning {

void Expansion::Clear() {
  choices_.clear();
  probabilities_.clear();
  words_.clear();
}

void Expansion::BeginChoice(int action) {
  choices_.push_back({action, static_cast<int>(probabilities_.size()), 0});
}

std::span<uint64_t> Expansion::AddOutcome(double probability, Bits start) {
  ++choices_.back().num_outcomes;
  probabilities_.push_back(probability);
  words_.insert(words_.end(), start.begin(), start.end());
  return std::span(words_).last(num_words_);
}

Estimate Model::Assess(std::span<uint64_t>) const {
  return {};
}

}  // namespace cell::planning
