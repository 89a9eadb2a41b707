#include "common/rexd/explorer.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace cell::rexd {

using namespace rules;
namespace {

/// What an action that has never done anything is worth, as literals of
/// difference.
constexpr double kCostOfUnknown = 2.5;
/// Of each trial of it: all actions are tried about as often.
constexpr double kCostOfTrial = 0.1;

int NumDifferences(const std::vector<bool>& a, const std::vector<bool>& b) {
  int number = 0;
  for (size_t i = 0; i < a.size(); ++i) number += a[i] != b[i];
  return number;
}

}  // namespace

Explorer::Explorer(const RexdTask& task, const Params& params)
    : task_(task),
      params_(params),
      learner_(task.world, params.learner),
      rules_{task.world->shared_symbols(), {}},
      random_(params.seed),
      acts_(GroundActs(*task.world, task.initial)) {
  if (acts_.empty()) {
    throw std::invalid_argument("no action is possible with these objects");
  }
  for (const int action : task.world->symbols().Actions()) {
    literals_[action] = LiteralsOf(action);
  }
}

std::vector<Literal> Explorer::LiteralsOf(int action) const {
  const SymbolTable& symbols = task_.world->symbols();
  std::vector<Term> terms = {{Term::Kind::kAny, 0}};
  for (int i = 0; i < symbols[action].arity; ++i) {
    terms.push_back({Term::Kind::kVariable, i});
  }
  std::vector<Literal> literals;
  for (size_t s = 0; s < symbols.all().size(); ++s) {
    const Symbol& symbol = symbols.all()[s];
    if (symbol.kind == Symbol::Kind::kAction || symbol.is_integer) continue;
    std::vector<Literal> open = {
        {static_cast<int>(s), {}, Comparison::kTrue, 0}};
    for (int i = 0; i < symbol.arity; ++i) {
      std::vector<Literal> longer;
      for (const Literal& literal : open) {
        for (const Term& term : terms) {
          longer.push_back(literal);
          longer.back().terms.push_back(term);
        }
      }
      open = std::move(longer);
    }
    std::erase_if(open, [](const Literal& literal) {
      return !literal.terms.empty() &&
             std::ranges::all_of(literal.terms, [](const Term& term) {
               return term.kind == Term::Kind::kAny;
             });
    });
    std::ranges::move(open, std::back_inserter(literals));
  }
  for (int i = 0; i < symbols[action].arity; ++i) {
    for (int j = i + 1; j < symbols[action].arity; ++j) {
      literals.push_back(
          {Literal::kSame,
           {{Term::Kind::kVariable, i}, {Term::Kind::kVariable, j}},
           Comparison::kTrue,
           0});
    }
  }
  return literals;
}

Explorer::Situation Explorer::SituationOf(const GroundAct& act,
                                          const WorldState& state) const {
  Situation situation;
  for (const Literal& literal : literals_.at(act.action)) {
    situation.push_back(Holds(literal, act.arguments, state, *task_.world));
  }
  return situation;
}

std::optional<double> Explorer::CostOf(const GroundAct& act,
                                       const WorldState& state) const {
  const auto it = trials_.find(act.action);
  if (it == trials_.end()) return 0;
  const Situation situation = SituationOf(act, state);
  const auto count = it->second.counts.find(situation);
  if (count != it->second.counts.end() &&
      count->second >= params_.known_count) {
    return std::nullopt;
  }
  if (it->second.positives.empty()) {
    return kCostOfUnknown + kCostOfTrial * it->second.num_trials;
  }
  int least = std::numeric_limits<int>::max();
  for (const Situation& positive : it->second.positives) {
    least = std::min(least, NumDifferences(situation, positive));
  }
  return least;
}

std::pair<double, std::vector<GroundAct>> Explorer::BestActs(
    const WorldState& state) const {
  std::pair<double, std::vector<GroundAct>> best = {
      std::numeric_limits<double>::infinity(), {}};
  for (const GroundAct& act : acts_) {
    const auto cost = CostOf(act, state);
    if (!cost || *cost > best.first) continue;
    if (*cost < best.first) best = {*cost, {}};
    best.second.push_back(act);
  }
  return best;
}

std::optional<WorldState> Explorer::Expected(const GroundAct& act,
                                             const WorldState& state) const {
  const auto coverage = FindCoverage(rules_, act, state, *task_.world);
  if (!coverage || coverage->rule->outcomes.empty()) return std::nullopt;
  const Trials& trials = trials_.at(act.action);
  const Situation situation = SituationOf(act, state);
  const auto count = trials.counts.find(situation);
  if (count != trials.counts.end() && count->second >= params_.known_count &&
      !trials.positives.contains(situation)) {
    return std::nullopt;
  }
  const Outcome& likeliest = *std::ranges::max_element(
      coverage->rule->outcomes, {}, &Outcome::probability);
  WorldState after = Apply(likeliest, coverage->binding, state, *task_.world);
  if (after == state) return std::nullopt;
  return after;
}

const GroundAct& Explorer::AnyOf(const std::vector<GroundAct>& acts) {
  return acts[static_cast<size_t>(
      random_.Below(static_cast<int>(acts.size())))];
}

GroundAct Explorer::Choose(const WorldState& state) {
  struct Node {
    WorldState state;
    std::optional<GroundAct> first;
    int depth = 0;
  };
  GroundAct best = AnyOf(acts_);
  double best_cost = std::numeric_limits<double>::infinity();
  std::deque<Node> open = {{state, std::nullopt, 0}};
  std::set<std::vector<uint64_t>> seen = {state.bits};
  for (int i = 0; !open.empty() && i < params_.max_states; ++i) {
    const Node node = std::move(open.front());
    open.pop_front();
    const auto [cost, acts] = BestActs(node.state);
    const double total = cost + params_.action_cost * node.depth;
    if (!acts.empty() && total < best_cost) {
      best_cost = total;
      best = node.first ? *node.first : AnyOf(acts);
    }
    if (node.depth == params_.max_depth) continue;
    for (const GroundAct& act : acts_) {
      auto after = Expected(act, node.state);
      if (!after || !seen.insert(after->bits).second) continue;
      open.push_back(
          {*std::move(after), node.first ? *node.first : act, node.depth + 1});
    }
  }
  return best;
}

void Explorer::Observe(const Experience& experience) {
  Trials& trials = trials_[experience.act.action];
  Situation situation = SituationOf(experience.act, experience.before);
  ++trials.num_trials;
  ++trials.counts[situation];
  if (experience.before != experience.after) {
    trials.positives.insert(std::move(situation));
  }
  learner_.Add(experience);
  learner_.Learn();
  rules_ = learner_.Rules();
}

}  // namespace cell::rexd
