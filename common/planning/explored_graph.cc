#include "common/planning/explored_graph.h"

#include <algorithm>
#include <utility>

namespace cell::planning {

ExploredGraph::ExploredGraph(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      table_(model_->num_words()),
      expansion_(model_->num_words()) {}

int64_t ExploredGraph::num_bytes() const {
  return table_.num_bytes() +
         static_cast<int64_t>(nodes_.capacity() * sizeof(Node) +
                              choices_.capacity() * sizeof(Choice) +
                              outcomes_.capacity() * sizeof(Outcome));
}

void ExploredGraph::Save(StateWriter* out) const {
  table_.Save(out);
  out->Put(nodes_);
  out->Put(choices_);
  out->Put(outcomes_);
  out->Put(num_states_);
  out->Put(num_expansions_);
}

void ExploredGraph::Restore(StateReader* in) {
  table_.Restore(in);
  in->Get(&nodes_);
  in->Get(&choices_);
  in->Get(&outcomes_);
  in->Get(&num_states_);
  in->Get(&num_expansions_);
}

int ExploredGraph::Enter(Bits state) {
  raw_.assign(state.begin(), state.end());
  const int number = table_.Enter(raw_);
  if (static_cast<size_t>(number) < nodes_.size()) {
    return nodes_[static_cast<size_t>(number)].same_as;
  }
  Node fresh;
  words_ = raw_;
  const Estimate estimate = model_->Assess(words_);
  const int same_as = words_ == raw_ ? number : table_.Enter(words_);
  fresh.same_as = same_as;
  fresh.is_goal = model_->IsGoal(words_);
  fresh.max_probability = estimate.max_probability;
  fresh.least_actions = static_cast<float>(estimate.least_actions);
  fresh.distance = static_cast<float>(estimate.distance);
  const size_t num_before = nodes_.size();
  nodes_.resize(static_cast<size_t>(table_.size()), fresh);
  num_states_ += static_cast<size_t>(same_as) >= num_before;
  return same_as;
}

std::optional<int> ExploredGraph::Find(Bits state) const {
  std::vector<uint64_t> words(state.begin(), state.end());
  model_->Assess(words);
  return table_.Find(words);
}

void ExploredGraph::Expand(int state) {
  const Bits words = table_.Words(state);
  // The table may move its words while states are entered.
  const std::vector<uint64_t> start(words.begin(), words.end());
  expansion_.Clear();
  model_->Expand(start, &expansion_);
  const int first = static_cast<int>(choices_.size());
  for (const Expansion::Choice& choice : expansion_.choices()) {
    AddChoice(choice, state);
  }
  Node& expanded = nodes_[static_cast<size_t>(state)];
  expanded.first_choice = first;
  expanded.num_choices = static_cast<int>(choices_.size()) - first;
  ++num_expansions_;
}

void ExploredGraph::AddChoice(const Expansion::Choice& choice, int state) {
  const size_t first = outcomes_.size();
  for (int i = 0; i < choice.num_outcomes; ++i) {
    const int index = choice.first_outcome + i;
    const int next = Enter(expansion_.state(index));
    const double probability = expansion_.probability(index);
    const auto known = std::find_if(
        outcomes_.begin() + static_cast<std::ptrdiff_t>(first), outcomes_.end(),
        [&](const Outcome& o) { return o.state == next; });
    if (known == outcomes_.end()) {
      outcomes_.push_back({next, probability});
    } else {
      known->probability += probability;
    }
  }
  const size_t number = outcomes_.size() - first;
  if (number == 1 && outcomes_.back().state == state) {
    outcomes_.pop_back();
    return;
  }
  choices_.push_back({state, choice.action, static_cast<int>(first),
                      static_cast<int>(number)});
}

}  // namespace cell::planning
