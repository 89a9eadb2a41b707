#include "services/planner/state_space.h"

#include <algorithm>
#include <utility>

namespace cell::planner {

StateSpace::StateSpace(std::shared_ptr<const RuleSet> rules, Agent agent,
                       const std::set<GroundAction>& blocked)
    : rules_(std::move(rules)), agent_(agent) {
  for (const GroundAction& action : rules_->GroundActions(agent)) {
    if (blocked.contains(action)) continue;
    actions_.push_back(action);
    std::vector<BoundRule>& bound = bound_rules_.emplace_back();
    for (const NdrRule& rule : rules_->ActionOf(action).rules) {
      if (!rule.IsFor(agent)) continue;
      bound.emplace_back(rule, action.arguments, rules_->vocabulary());
      if (!bound.back().is_possible()) bound.pop_back();
    }
  }
}

std::optional<int> StateSpace::Enter(const State& state, int max_states) {
  const int entered = IndexOf(state);
  while (candidates_.size() < states_.size()) {
    candidates_.push_back(CandidatesIn(static_cast<int>(candidates_.size())));
    if (size() > max_states) {
      states_.clear();
      candidates_.clear();
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

std::vector<StateSpace::Candidate> StateSpace::CandidatesIn(int state) {
  std::vector<Candidate> candidates;
  const bool has_unknown = states_[state].HasUnknown();
  for (size_t i = 0; i < actions_.size(); ++i) {
    std::vector<const BoundRule*> covering;
    for (const BoundRule& rule : bound_rules_[i]) {
      if (rule.MayCover(states_[state])) covering.push_back(&rule);
    }
    // Of several rules one may be right if something is unknown.
    if (covering.size() > 1 && !has_unknown) continue;
    for (const BoundRule* rule : covering) {
      Candidate candidate = Try(static_cast<int>(i), *rule, state);
      if (!candidate.moves.empty()) candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

StateSpace::Candidate StateSpace::Try(int action, const BoundRule& rule,
                                      int state) {
  Candidate candidate{action, rule.rule().noise, {}};
  for (size_t i = 0; i < rule.rule().outcomes.size(); ++i) {
    const Outcome& outcome = rule.rule().outcomes[i];
    if (outcome.probability == 0) continue;
    const int after = IndexOf(rule.After(i, states_[state]));
    if (after == state) {
      candidate.stay += outcome.probability;
      continue;
    }
    const auto known =
        std::find_if(candidate.moves.begin(), candidate.moves.end(),
                     [&](const Move& move) { return move.state == after; });
    if (known == candidate.moves.end()) {
      candidate.moves.push_back({after, outcome.probability});
    } else {
      known->probability += outcome.probability;
    }
  }
  return candidate;
}

std::vector<int> StateSpace::ReachableFrom(int state) const {
  std::vector<bool> is_reached(states_.size());
  std::vector<int> reached = {state};
  is_reached.at(state) = true;
  for (size_t i = 0; i < reached.size(); ++i) {
    for (const Candidate& candidate : candidates_[reached[i]]) {
      for (const Move& move : candidate.moves) {
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
