#include "services/planner/state_space.h"

#include <algorithm>
#include <utility>

namespace cell::planner {

StateSpace::StateSpace(std::shared_ptr<const RuleSet> rules, Agent agent,
                       const std::set<GroundAction>& blocked)
    : rules_(std::move(rules)), agent_(agent) {
  for (const GroundAction& action : rules_->GroundActions(agent)) {
    if (!blocked.contains(action)) actions_.push_back(action);
  }
}

std::optional<int> StateSpace::Enter(const State& state, int max_states) {
  const int entered = IndexOf(state);
  while (choices_.size() < states_.size()) {
    choices_.push_back(ChoicesIn(static_cast<int>(choices_.size())));
    if (size() > max_states) {
      states_.clear();
      choices_.clear();
      index_of_.clear();
      return std::nullopt;
    }
  }
  return entered;
}

int StateSpace::IndexOf(const State& state) {
  const auto [it, is_new] = index_of_.try_emplace(state, size());
  if (is_new) states_.push_back(state);
  return it->second;
}

std::vector<StateSpace::Choice> StateSpace::ChoicesIn(int state) {
  std::vector<Choice> choices;
  const bool has_unknown = states_[state].HasUnknown();
  for (size_t i = 0; i < actions_.size(); ++i) {
    const auto covers =
        CoversOf(rules_->ActionOf(actions_[i]), actions_[i].arguments,
                 states_[state], rules_->vocabulary(), agent_);
    // Of several rules one may be right if something is unknown.
    if (covers.size() > 1 && !has_unknown) continue;
    for (const Cover& cover : covers) {
      Choice choice = Try(static_cast<int>(i), cover, state);
      if (!choice.moves.empty()) choices.push_back(std::move(choice));
    }
  }
  return choices;
}

StateSpace::Choice StateSpace::Try(int action, const Cover& cover, int state) {
  const NdrRule& rule = rules_->ActionOf(actions_[action]).rules[cover.rule];
  Choice choice{action, rule.noise, {}};
  for (const Outcome& outcome : rule.outcomes) {
    if (outcome.probability == 0) continue;
    const int after = IndexOf(
        After(outcome, cover.binding, states_[state], rules_->vocabulary()));
    if (after == state) {
      choice.stay += outcome.probability;
      continue;
    }
    const auto known =
        std::find_if(choice.moves.begin(), choice.moves.end(),
                     [&](const Move& move) { return move.state == after; });
    if (known == choice.moves.end()) {
      choice.moves.push_back({after, outcome.probability});
    } else {
      known->probability += outcome.probability;
    }
  }
  return choice;
}

std::vector<int> StateSpace::ReachableFrom(int state) const {
  std::vector<bool> is_reached(states_.size());
  std::vector<int> reached = {state};
  is_reached.at(state) = true;
  for (size_t i = 0; i < reached.size(); ++i) {
    for (const Choice& choice : choices_[reached[i]]) {
      for (const Move& move : choice.moves) {
        if (is_reached[move.state]) continue;
        is_reached[move.state] = true;
        reached.push_back(move.state);
      }
    }
  }
  std::sort(reached.begin(), reached.end());
  return reached;
}

}  // namespace cell::planner
