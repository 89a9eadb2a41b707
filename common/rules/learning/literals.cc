// The literals that search operators choose from.
#include <algorithm>
#include <functional>

#include "common/rules/learning/rule_search.h"

namespace cell::rules {
namespace {

/// Calls visit(feature) with every choice of terms for its first `arity`.
void ForEachFeature(Feature feature, int arity,
                    const std::vector<int32_t>& terms,
                    const std::function<void(const Feature&)>& visit,
                    size_t next = 0) {
  if (next == static_cast<size_t>(arity)) return visit(feature);
  for (const int32_t term : terms) {
    feature.terms[next] = term;
    ForEachFeature(feature, arity, terms, visit, next + 1);
  }
}

std::vector<int32_t> VariablesOf(const FeatureTable& table,
                                 const std::vector<int>& references) {
  std::vector<int32_t> terms;
  for (int i = 0; i < table.num_arguments(); ++i) terms.push_back(i);
  terms.insert(terms.end(), references.begin(), references.end());
  return terms;
}

void AddPredicates(const World& world, const std::vector<int32_t>& terms,
                   std::vector<Feature>* features) {
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const Symbol& symbol = world.symbols().all()[s];
    if (symbol.kind == Symbol::Kind::kAction || symbol.is_integer) continue;
    Feature feature;
    feature.symbol = static_cast<int32_t>(s);
    ForEachFeature(feature, symbol.arity, terms, [&](const Feature& f) {
      features->push_back(f);
      features->push_back(f.Negated());
    });
  }
}

void AddFunctions(const FeatureTable& table, const std::vector<int32_t>& terms,
                  std::vector<Feature>* features) {
  const World& world = table.world();
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const Symbol& symbol = world.symbols().all()[s];
    if (!symbol.is_integer) continue;
    Feature feature;
    feature.symbol = static_cast<int32_t>(s);
    feature.comparison = Comparison::kEqual;
    for (const int value : table.ValuesOf(feature.symbol)) {
      feature.value = value;
      ForEachFeature(feature, symbol.arity, terms,
                     [&](const Feature& f) { features->push_back(f); });
    }
  }
}

/// That two terms are one object.
void AddSame(const std::vector<int32_t>& terms,
             std::vector<Feature>* features) {
  for (size_t i = 0; i + 1 < terms.size(); ++i) {
    for (size_t j = i + 1; j < terms.size(); ++j) {
      if (terms[i] <= Feature::kNone) continue;
      Feature feature;
      feature.symbol = Literal::kSame;
      feature.terms = {terms[i], terms[j], Feature::kNone};
      features->push_back(feature);
      features->push_back(feature.Negated());
    }
  }
}

}  // namespace

const std::vector<int>& RuleSearch::Literals(
    const std::vector<int>& references) {
  auto& numbers = literals_[references];
  if (!numbers.empty()) return numbers;
  const std::vector<int32_t> variables = VariablesOf(table_, references);
  std::vector<int32_t> terms = variables;
  for (int i = 0; i < table_.world().num_constants(); ++i) {
    terms.push_back(Feature::ObjectCode(i));
  }
  std::vector<int32_t> quantified = terms;
  if (options_.is_quantified) quantified.push_back(Feature::kAny);
  std::vector<Feature> features;
  AddPredicates(table_.world(), quantified, &features);
  AddSame(terms, &features);
  AddFunctions(table_, variables, &features);
  std::ranges::stable_sort(features, std::less(), [](const Feature& f) {
    return std::ranges::count_if(f.terms,
                                 [](int32_t t) { return t == Feature::kAny; });
  });
  for (const Feature& f : features) numbers.push_back(table_.Number(f));
  return numbers;
}

std::vector<Feature> RuleSearch::Definitions(
    const std::vector<int>& references) const {
  std::vector<int32_t> terms = VariablesOf(table_, references);
  terms.push_back(Feature::kSelf);
  std::vector<Feature> features;
  AddSame(terms, &features);
  if (options_.is_quantified) terms.push_back(Feature::kAny);
  AddPredicates(table_.world(), terms, &features);
  std::erase_if(features, [](const Feature& feature) {
    return !feature.Names(Feature::kSelf);
  });
  return features;
}

}  // namespace cell::rules
