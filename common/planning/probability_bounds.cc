#include "common/planning/probability_bounds.h"

#include <algorithm>
#include <cmath>

#include "common/planning/end_components.h"

namespace cell::planning {
namespace {

constexpr double kTie = 1e-13;

}  // namespace

void ProbabilityBounds::Extend() {
  for (int s = static_cast<int>(parent_.size()); s < graph_.size(); ++s) {
    const bool is_goal = graph_.IsGoal(s);
    low_.push_back(is_goal ? 1 : 0);
    high_.push_back(is_goal ? 1 : graph_.max_probability(s));
    parent_.push_back(s);
    members_of_.push_back(-1);
  }
}

int ProbabilityBounds::BlockOf(int state) {
  while (parent_[Index(state)] != state) {
    int& parent = parent_[Index(state)];
    parent = parent_[Index(parent)];
    state = parent;
  }
  return state;
}

ProbabilityBounds::Value ProbabilityBounds::Of(
    const ExploredGraph::Choice& choice) {
  const int block = BlockOf(choice.state);
  Value value;
  double leaving = 0;
  for (const auto& outcome : graph_.outcomes(choice)) {
    const int next = BlockOf(outcome.state);
    if (next == block) continue;
    leaving += outcome.probability;
    value.low += outcome.probability * low_[Index(next)];
    value.high += outcome.probability * high_[Index(next)];
    if (high_[Index(next)] > 0) {
      value.distance += outcome.probability * graph_.distance(outcome.state);
    }
  }
  if (leaving <= 0) return {};
  value.leaves = true;
  value.low /= leaving;
  value.high /= leaving;
  value.distance /= leaving;
  return value;
}

ProbabilityBounds::Update ProbabilityBounds::Improve(int block) {
  Update update;
  double best_high = 0;
  double best_low = 0;
  double distance = 0;
  double safe_distance = 0;
  ForEachChoice(block, [&](int c) {
    const Value value = Of(graph_.choice(c));
    if (!value.leaves) return;
    const bool is_safer =
        update.safe_choice < 0 || value.low > best_low + kTie ||
        (value.low > best_low - kTie && value.distance < safe_distance);
    if (is_safer) {
      update.safe_choice = c;
      safe_distance = value.distance;
    }
    best_low = std::max(best_low, value.low);
    const bool is_better =
        update.choice < 0 || value.high > best_high + kTie ||
        (value.high > best_high - kTie && value.distance < distance);
    if (is_better) {
      update.choice = c;
      distance = value.distance;
    }
    best_high = std::max(best_high, value.high);
  });
  double& low = low_[Index(block)];
  double& high = high_[Index(block)];
  // Rounding must not let the bounds cross.
  best_high = std::max(best_high, low);
  best_low = std::min(best_low, high);
  update.drop = std::max(0.0, high - best_high);
  update.change = std::max(update.drop, best_low - low);
  high = std::min(high, best_high);
  low = std::max(low, best_low);
  return update;
}

bool ProbabilityBounds::CollapseEndComponents(const std::vector<int>& blocks) {
  LocalGraph local;
  std::vector<std::pair<int, int>> place_of;  // of each block, sorted
  for (size_t i = 0; i < blocks.size(); ++i) {
    place_of.emplace_back(blocks[i], static_cast<int>(i));
  }
  std::ranges::sort(place_of);
  const auto place = [&](int block) {
    const auto it = std::ranges::lower_bound(place_of, std::pair(block, 0));
    return it != place_of.end() && it->first == block ? it->second : -1;
  };
  for (const int block : blocks) {
    local.emplace_back();
    ForEachChoice(block, [&](int c) {
      std::vector<int> targets;
      for (const auto& outcome : graph_.outcomes(graph_.choice(c))) {
        targets.push_back(place(BlockOf(outcome.state)));
      }
      // A choice that may leave the blocks stays in no end component.
      if (std::ranges::count(targets, -1) > 0) return;
      local.back().push_back(std::move(targets));
    });
  }
  bool has_collapsed = false;
  for (const std::vector<int>& component : EndComponents(local)) {
    if (component.size() < 2) continue;
    std::vector<int> merged;
    for (const int i : component) merged.push_back(blocks[Index(i)]);
    Merge(merged);
    has_collapsed = true;
  }
  return has_collapsed;
}

void ProbabilityBounds::Merge(const std::vector<int>& blocks) {
  const int head = blocks.front();
  std::vector<int> choices;
  double low = 0;
  double high = 1;
  for (const int block : blocks) {
    ForEachChoice(block, [&](int c) { choices.push_back(c); });
    low = std::max(low, low_[Index(block)]);
    high = std::min(high, high_[Index(block)]);
    const int old = members_of_[Index(block)];
    if (old >= 0) choices_of_[Index(old)] = {};
    parent_[Index(block)] = head;
  }
  // What stays inside never counts again.
  std::erase_if(choices, [&](int c) {
    return std::ranges::all_of(
        graph_.outcomes(graph_.choice(c)),
        [&](const auto& outcome) { return BlockOf(outcome.state) == head; });
  });
  low_[Index(head)] = low;
  high_[Index(head)] = choices.empty() ? low : std::max(low, high);
  members_of_[Index(head)] = static_cast<int>(choices_of_.size());
  choices_of_.push_back(std::move(choices));
}

int64_t ProbabilityBounds::num_bytes() const {
  int64_t bytes = static_cast<int64_t>(
      (low_.capacity() + high_.capacity()) * sizeof(double) +
      (parent_.capacity() + members_of_.capacity()) * sizeof(int) +
      choices_of_.capacity() * sizeof(std::vector<int>));
  for (const auto& choices : choices_of_) {
    bytes += static_cast<int64_t>(choices.capacity() * sizeof(int));
  }
  return bytes;
}

void ProbabilityBounds::Save(StateWriter* out) const {
  out->Put(low_);
  out->Put(high_);
  out->Put(parent_);
  out->Put(members_of_);
  out->Put(uint64_t{choices_of_.size()});
  out->Put(uint64_t{choices_of_.capacity()});
  for (const auto& choices : choices_of_) out->Put(choices);
}

void ProbabilityBounds::Restore(StateReader* in) {
  in->Get(&low_);
  in->Get(&high_);
  in->Get(&parent_);
  in->Get(&members_of_);
  uint64_t size = 0;
  uint64_t capacity = 0;
  in->Get(&size);
  in->Get(&capacity);
  in->RequireSize(size, capacity, sizeof(uint64_t));
  choices_of_.clear();
  choices_of_.reserve(capacity);
  choices_of_.resize(size);
  for (auto& choices : choices_of_) in->Get(&choices);
}

}  // namespace cell::planning
