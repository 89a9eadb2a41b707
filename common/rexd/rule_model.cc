#include "common/rexd/rule_model.h"

#include <algorithm>
#include <numeric>

namespace cell::rexd {

using namespace rules;

RuleModel::RuleModel(NdrRules rules, const RexdTask& task,
                     std::vector<GroundAct> acts, IsForbidden is_forbidden)
    : rules_(std::move(rules)),
      task_(task),
      acts_(std::move(acts)),
      is_forbidden_(std::move(is_forbidden)) {
  FindRelevant();
  FindAchievable();
}

// The bits of the atoms, then the values of the functions.
int RuleModel::num_words() const {
  return static_cast<int>(task_.initial.bits.size() +
                          task_.initial.values.size());
}

std::vector<uint64_t> RuleModel::Pack(const WorldState& state) const {
  std::vector<uint64_t> words = state.bits;
  for (const int value : state.values) {
    words.push_back(static_cast<uint64_t>(static_cast<int64_t>(value)));
  }
  return words;
}

WorldState RuleModel::Unpack(planning::Bits words) const {
  WorldState state = task_.initial;
  const size_t num_bits = state.bits.size();
  std::copy_n(words.begin(), num_bits, state.bits.begin());
  for (size_t i = 0; i < state.values.size(); ++i) {
    state.values[i] =
        static_cast<int>(static_cast<int64_t>(words[num_bits + i]));
  }
  return state;
}

bool RuleModel::IsGoal(planning::Bits words) const {
  return task_.IsGoal(Unpack(words));
}

void RuleModel::Expand(planning::Bits words,
                       planning::Expansion* expansion) const {
  const WorldState state = Unpack(words);
  for (const size_t i : coverable_) {
    const auto coverage = FindCoverage(rules_, acts_[i], state, *task_.world);
    if (!coverage) continue;
    if (is_forbidden_ && is_forbidden_(acts_[i], state)) continue;
    double rest = 1;
    bool has_begun = false;
    for (const Outcome& outcome : coverage->rule->outcomes) {
      if (outcome.probability <= 0) continue;
      const std::vector<uint64_t> next =
          Pack(Apply(outcome, coverage->binding, state, *task_.world));
      if (std::ranges::equal(next, words)) continue;
      if (!has_begun) expansion->BeginChoice(static_cast<int>(i));
      has_begun = true;
      rest -= outcome.probability;
      std::ranges::copy(
          next, expansion->AddOutcome(outcome.probability, words).begin());
    }
    if (has_begun && rest > 1e-12) expansion->AddOutcome(rest, words);
  }
}

void RuleModel::FindRelevant() {
  const World& world = *task_.world;
  relevant_.assign(task_.initial.bits.size(), is_forbidden_ ? ~uint64_t{0} : 0);
  std::set<int> symbols;
  const auto add = [&](const std::vector<Literal>& literals) {
    for (const Literal& literal : literals) symbols.insert(literal.symbol);
  };
  add(task_.goal);
  for (const Rule& rule : rules_.rules) {
    add(rule.context);
    for (const Reference& reference : rule.references) add(reference.literals);
  }
  for (size_t s = world.symbols().all().size(); s-- > 0;) {
    const int symbol = static_cast<int>(s);
    const Definition& definition = world.symbols()[symbol].definition;
    if (!symbols.contains(symbol)) continue;
    if (definition.of >= 0) symbols.insert(definition.of);
    for (const auto& atom : definition.atoms) symbols.insert(atom.symbol);
    if (world.symbols()[symbol].is_integer) continue;
    for (int i = 0; i < world.num_places(symbol); ++i) {
      const int place = world.first(symbol) + i;
      relevant_[static_cast<size_t>(place) / 64] |= uint64_t{1} << (place % 64);
    }
  }
}

bool RuleModel::MayEverHold(const Literal& literal,
                            const GroundAct& act) const {
  const bool is_over_arguments =
      std::ranges::all_of(literal.terms, [&](const Term& term) {
        return term.kind != Term::Kind::kVariable ||
               term.index < static_cast<int>(act.arguments.size());
      });
  const bool may_change = literal.symbol != Literal::kSame &&
                          (changing_.contains(literal.symbol) ||
                           task_.world->symbols()[literal.symbol].is_derived());
  return !is_over_arguments || may_change ||
         Holds(literal, act.arguments, task_.initial, *task_.world);
}

std::vector<int> RuleModel::ObjectsOf(const Term& term,
                                      const GroundAct& act) const {
  if (term.kind == Term::Kind::kObject) return {term.index};
  if (term.index < static_cast<int>(act.arguments.size())) {
    return {act.arguments[static_cast<size_t>(term.index)]};
  }
  std::vector<int> all(static_cast<size_t>(task_.world->num_objects()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void RuleModel::AddAchievable(const Rule& rule, const GroundAct& act) {
  const World& world = *task_.world;
  for (const Outcome& outcome : rule.outcomes) {
    int num_changes = 0;
    for (const Literal& change : outcome.changes) {
      if (world.symbols()[change.symbol].is_integer) continue;
      num_changes +=
          std::ranges::count(task_.goal, change.symbol, &Literal::symbol) > 0;
      std::vector<int> places = {0};
      for (const Term& term : change.terms) {
        const std::vector<int> objects = ObjectsOf(term, act);
        std::vector<int> next;
        for (const int place : places) {
          for (const int object : objects) {
            next.push_back(place * world.num_objects() + object);
          }
        }
        places = std::move(next);
      }
      for (const int place : places) {
        achievable_.insert(2 * (world.first(change.symbol) + place) +
                           (change.comparison == Comparison::kTrue));
      }
    }
    most_changes_ = std::max(most_changes_, num_changes);
  }
}

void RuleModel::FindAchievable() {
  for (const Rule& rule : rules_.rules) {
    for (const Outcome& outcome : rule.outcomes) {
      for (const Literal& l : outcome.changes) changing_.insert(l.symbol);
    }
  }
  for (size_t i = 0; i < acts_.size(); ++i) {
    const GroundAct& act = acts_[i];
    bool is_coverable = false;
    for (const Rule& rule : rules_.rules) {
      if (rule.action == act.action &&
          std::ranges::all_of(rule.context, [&](const Literal& literal) {
            return MayEverHold(literal, act);
          })) {
        AddAchievable(rule, act);
        is_coverable = true;
      }
    }
    if (is_coverable) coverable_.push_back(i);
  }
}

bool RuleModel::IsMissing(const Literal& goal, planning::Bits state) const {
  std::vector<int> objects;
  for (const Term& term : goal.terms) objects.push_back(term.index);
  const int place = task_.world->PlaceOf(goal.symbol, objects);
  const bool is_true =
      state[static_cast<size_t>(place) / 64] >> (place % 64) & 1;
  return is_true != (goal.comparison == Comparison::kTrue);
}

planning::Estimate RuleModel::Assess(std::span<uint64_t> state) const {
  planning::Estimate estimate;
  for (size_t i = 0; i < relevant_.size(); ++i) state[i] &= relevant_[i];
  int num_missing = 0;
  for (const Literal& goal : task_.goal) {
    if (!IsMissing(goal, state)) continue;
    if (task_.world->symbols()[goal.symbol].is_derived()) continue;
    ++num_missing;
    std::vector<int> objects;
    for (const Term& term : goal.terms) objects.push_back(term.index);
    const int place = task_.world->PlaceOf(goal.symbol, objects);
    const int wanted =
        2 * place + (goal.comparison == Comparison::kTrue ? 1 : 0);
    if (!achievable_.contains(wanted)) estimate.max_probability = 0;
  }
  estimate.distance = num_missing;
  estimate.least_actions = (num_missing + most_changes_ - 1) / most_changes_;
  return estimate;
}

std::string RuleModel::ActionName(int action) const {
  const GroundAct& act = acts_.at(static_cast<size_t>(action));
  return task_.world->Show(act.action, act.arguments);
}

}  // namespace cell::rexd
