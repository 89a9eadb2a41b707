#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/planning/model.h"
#include "common/planning/state_table.h"

namespace cell::planning {

/// The part of a model that a search has explored. States are numbers; states
/// that the model takes for the same (Model::Assess) have the same number.
class ExploredGraph {
 public:
  struct Choice {
    int state;
    int action;
    int first_outcome;
    int num_outcomes;
  };
  struct Outcome {
    int state;
    double probability;
  };

  explicit ExploredGraph(std::shared_ptr<const Model> model);

  const Model& model() const { return *model_; }
  /// Numbers below this one are in use; not all of them are states.
  int size() const { return table_.size(); }
  int num_states() const { return num_states_; }
  int64_t num_expansions() const { return num_expansions_; }
  int64_t num_bytes() const;

  int Enter(Bits state);
  /// nullopt if the state was never entered.
  std::optional<int> Find(Bits state) const;

  bool IsGoal(int state) const { return node(state).is_goal; }
  bool IsExpanded(int state) const { return node(state).num_choices >= 0; }
  double max_probability(int state) const {
    return node(state).max_probability;
  }
  /// See Estimate.
  double least_actions(int state) const { return node(state).least_actions; }
  double distance(int state) const { return node(state).distance; }

  /// Finds the choices of a state; those that change nothing are left out, and
  /// each has every state once.
  void Expand(int state);
  int first_choice(int state) const { return node(state).first_choice; }
  int num_choices(int state) const { return node(state).num_choices; }
  const Choice& choice(int index) const {
    return choices_[static_cast<size_t>(index)];
  }
  std::span<const Outcome> outcomes(const Choice& choice) const {
    return std::span(outcomes_).subspan(
        static_cast<size_t>(choice.first_outcome),
        static_cast<size_t>(choice.num_outcomes));
  }

  void Save(StateWriter* out) const;
  /// In place of what was explored; the model has to be the same.
  /// @throws as StateReader does
  void Restore(StateReader* in);

 private:
  struct Node {
    int same_as = -1;  // the number of its state
    int first_choice = 0;
    int num_choices = -1;  // not expanded
    double max_probability = 0;
    float least_actions = 0;
    float distance = 0;
    bool is_goal = false;
  };

  const Node& node(int state) const {
    return nodes_[static_cast<size_t>(state)];
  }
  void AddChoice(const Expansion::Choice& choice, int state);

  std::shared_ptr<const Model> model_;
  StateTable table_;
  std::vector<Node> nodes_;
  std::vector<Choice> choices_;
  std::vector<Outcome> outcomes_;
  Expansion expansion_;
  std::vector<uint64_t> raw_, words_;  // scratch
  int num_states_ = 0;
  int64_t num_expansions_ = 0;
};

}  // namespace cell::planning
