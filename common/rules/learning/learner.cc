#include "common/rules/learning/learner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cell::rules {
namespace {

/// Number of a rule's variable that a term stands for.
int VariableOf(int32_t term, const SearchRule& rule, int num_arguments) {
  if (term < num_arguments) return term;
  const auto it = std::ranges::find(rule.references, term);
  return num_arguments + static_cast<int>(it - rule.references.begin());
}

Literal ToLiteral(const Feature& feature, const SearchRule& rule,
                  const FeatureTable& table, int self) {
  Literal literal;
  literal.symbol = feature.symbol;
  literal.comparison = feature.comparison;
  literal.value = feature.value;
  for (const int32_t term : feature.terms) {
    if (term == Feature::kNone) break;
    if (term == Feature::kAny) {
      literal.terms.push_back({Term::Kind::kAny, 0});
    } else if (term == Feature::kSelf) {
      literal.terms.push_back({Term::Kind::kVariable, self});
    } else if (term < 0) {
      literal.terms.push_back({Term::Kind::kObject, Feature::ObjectOf(term)});
    } else {
      literal.terms.push_back({Term::Kind::kVariable,
                               VariableOf(term, rule, table.num_arguments())});
    }
  }
  return literal;
}

std::string NameOfVariable(size_t index) {
  constexpr char kNames[] = "XYZUVW";
  if (index < 6) return std::string(1, kNames[index]);
  return "V" + std::to_string(index);
}

/// Names references apart from arguments.
std::vector<std::string> VariableNames(size_t number) {
  std::vector<std::string> names;
  for (size_t i = 0; i < number; ++i) names.push_back(NameOfVariable(i));
  return names;
}

}  // namespace

Rule ToRule(const SearchRule& from, const FeatureTable& table) {
  Rule rule;
  rule.action = table.action();
  const auto num_arguments = static_cast<size_t>(table.num_arguments());
  const auto names = VariableNames(num_arguments + from.references.size());
  rule.arguments.assign(
      names.begin(),
      names.begin() + static_cast<std::ptrdiff_t>(num_arguments));
  for (size_t i = 0; i < from.references.size(); ++i) {
    Reference reference{names[num_arguments + i], {}};
    for (const Feature& feature : table.definition(from.references[i])) {
      reference.literals.push_back(
          ToLiteral(feature, from, table, static_cast<int>(num_arguments + i)));
    }
    rule.references.push_back(std::move(reference));
  }
  for (const int number : from.context) {
    rule.context.push_back(ToLiteral(table.feature(number), from, table, -1));
  }
  for (const InducedOutcome& induced : from.induced->outcomes) {
    Outcome outcome{induced.probability, {}};
    for (const Feature& change : induced.changes) {
      outcome.changes.push_back(ToLiteral(change, from, table, -1));
    }
    rule.outcomes.push_back(std::move(outcome));
  }
  rule.noise = from.induced->noise;
  return rule;
}

Learner::Learner(std::shared_ptr<const World> world,
                 const LearnerOptions& options)
    : world_(std::move(world)), options_(options) {}

void Learner::Add(const Experience& experience) {
  const WorldState empty = world_->EmptyState();
  for (const WorldState* state : {&experience.before, &experience.after}) {
    if (state->bits.size() != empty.bits.size() ||
        state->values.size() != empty.values.size()) {
      throw std::invalid_argument("an experience is of another world");
    }
  }
  auto& search = searches_[experience.act.action];
  if (!search) {
    search =
        std::make_unique<RuleSearch>(world_, experience.act.action, options_);
  }
  search->Add(experience);
  is_new_[experience.act.action] = true;
}

void Learner::Learn() {
  for (auto& [action, is_new] : is_new_) {
    if (is_new) searches_.at(action)->Run();
    is_new = false;
  }
}

std::vector<std::pair<const RuleSearch*, const SearchRule*>>
Learner::SortedRules() const {
  std::vector<std::pair<const RuleSearch*, const SearchRule*>> all;
  for (const auto& [action, search] : searches_) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    for (const SearchRule& rule : search->rules()) {
      all.emplace_back(search.get(), &rule);
    }
    std::stable_sort(
        all.begin() + first, all.end(), [](const auto& a, const auto& b) {
          return a.second->covers.Count() > b.second->covers.Count();
        });
  }
  return all;
}

NdrRules Learner::Rules() const {
  NdrRules rules{world_->shared_symbols(), {}};
  for (const auto& [search, rule] : SortedRules()) {
    rules.rules.push_back(ToRule(*rule, search->table()));
  }
  return rules;
}

std::vector<int> Learner::RuleCounts() const {
  std::vector<int> counts;
  for (const auto& [search, rule] : SortedRules()) {
    counts.push_back(rule->covers.Count());
  }
  return counts;
}

double Learner::Score() const {
  double score = 0;
  for (const auto& [action, search] : searches_) score += search->score();
  return score;
}

const RuleSearch* Learner::SearchOf(int action) const {
  const auto it = searches_.find(action);
  return it == searches_.end() ? nullptr : it->second.get();
}

}  // namespace cell::rules
