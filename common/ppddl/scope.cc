#include "common/ppddl/scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

#include "common/config/decimal.h"
#include "common/text/counted.h"
#include "common/text/nearest.h"

namespace cell::ppddl {
namespace {

/// The place that `name` has in `known`.
int Find(const Expression& name, const std::string& what,
         const std::map<std::string, int>& known) {
  if (name.is_list) name.Fail("a list stands where a " + what + " should");
  const auto it = known.find(name.word);
  if (it == known.end()) {
    name.Fail("there is no " + what + " '" + name.word + "'" +
              (known.empty() ? "; the domain declares none"
                             : NamesInstead(name.word, KeysOf(known))));
  }
  return it->second;
}

template <class Range>
std::map<std::string, int> PlacesOf(const Range& named) {
  std::map<std::string, int> places;
  for (const auto& element : named) {
    places.emplace(element.name, static_cast<int>(places.size()));
  }
  return places;
}

/// Nothing unless it is a number or a fraction of two whole ones.
Result<double> ParseNumber(std::string_view word) {
  const size_t slash = word.find('/');
  if (slash == std::string_view::npos) return ParseDecimal<double>(word);
  const auto above = ParseDecimal<int64_t>(word.substr(0, slash));
  const auto below = ParseDecimal<int64_t>(word.substr(slash + 1));
  if (!above) return Reason{above.reason()};
  if (!below) return Reason{below.reason()};
  if (*below == 0) return Reason{"has the denominator 0"};
  return static_cast<double>(*above) / static_cast<double>(*below);
}

}  // namespace

Scope::Scope(const Domain& domain)
    : domain_(domain),
      types_(PlacesOf(domain.types)),
      predicates_(PlacesOf(domain.predicates)),
      functions_(PlacesOf(domain.functions)) {
  for (const Object& constant : domain.constants) {
    AddObject(constant, Expression{});
  }
}

void Scope::AddObject(const Object& object, const Expression& where) {
  const int index = static_cast<int>(objects_.size());
  if (!object_of_.emplace(object.name, index).second) {
    where.Fail("there are two objects '" + object.name + "'; rename one");
  }
  objects_.push_back(object);
}

void Scope::AddVariables(const std::vector<Variable>& variables) {
  variables_.insert(variables_.end(), variables.begin(), variables.end());
}

void Scope::RemoveVariables(size_t number) {
  variables_.resize(variables_.size() - number);
}

int Scope::TypeOf(const Expression& name) const {
  if (name.BeginsWith("either")) {
    name.Fail("(either ...) is not supported; declare a common parent type");
  }
  return Find(name, "type", types_);
}

int Scope::PredicateOf(const Expression& name) const {
  return Find(name, "predicate", predicates_);
}

int Scope::FunctionOf(const Expression& name) const {
  return Find(name, "function", functions_);
}

Term Scope::TermOf(const Expression& name) const {
  if (!name.is_list && name.word.starts_with('?')) {
    for (size_t i = 0; i < variables_.size(); ++i) {
      if (variables_[i].name == name.word) return {true, static_cast<int>(i)};
    }
    name.Fail(
        "there is no variable '" + name.word + "'" +
        (variables_.empty()
             ? " here; only objects are allowed"
             : NamesInstead(name.word, NamesIn(variables_, &Variable::name))));
  }
  return {false, Find(name, "object", object_of_)};
}

int Scope::TypeOfTerm(const Term& term) const {
  const auto index = static_cast<size_t>(term.index);
  return term.is_variable ? variables_[index].type : objects_[index].type;
}

std::vector<Term> Scope::ArgumentsOf(const Expression& list,
                                     const Symbol& symbol) const {
  const size_t number = symbol.parameters.size();
  if (list.items.size() != number + 1) {
    list.Fail(fmt::format("'{}' takes {}, not {}", symbol.name,
                          Counted(static_cast<int64_t>(number), "argument"),
                          list.items.size() - 1));
  }
  std::vector<Term> terms;
  for (size_t i = 0; i < number; ++i) {
    const Expression& item = list.items[i + 1];
    terms.push_back(TermOf(item));
    const int type = TypeOfTerm(terms.back());
    const int wanted = symbol.parameters[i].type;
    // An argument of a wider type may still turn out to fit.
    if (!domain_.IsA(type, wanted) &&
        (!terms.back().is_variable || !domain_.IsA(wanted, type))) {
      const auto name_of = [&](int t) {
        return domain_.types[static_cast<size_t>(t)].name;
      };
      item.Fail(fmt::format("'{}' is of the type '{}', but '{}' takes '{}'",
                            item.word, name_of(type), symbol.name,
                            name_of(wanted)));
    }
  }
  return terms;
}

std::vector<TypedName> ReadTypedNames(const Expression& list, size_t first,
                                      const Scope& scope) {
  std::vector<TypedName> names;
  size_t num_typed = 0;
  for (size_t i = first; i < list.items.size(); ++i) {
    const Expression& item = list.items[i];
    if (!item.Is("-")) {
      if (item.is_list) item.Fail("a list stands where a name should");
      names.push_back({&item, 0});
      continue;
    }
    if (++i == list.items.size() || names.size() == num_typed) {
      item.Fail("'-' stands between names and their type: a b - block");
    }
    const int type = scope.TypeOf(list.items[i]);
    for (; num_typed < names.size(); ++num_typed) names[num_typed].type = type;
  }
  return names;
}

std::vector<Variable> ReadVariables(const Expression& list, size_t first,
                                    const Scope& scope) {
  std::vector<Variable> variables;
  for (const auto& [name, type] : ReadTypedNames(list, first, scope)) {
    if (!name->word.starts_with('?') || name->word.size() < 2) {
      name->Fail("'" + name->word + "' is no variable: those begin with ?");
    }
    const auto is_same = [&](const Variable& v) {
      return v.name == name->word;
    };
    if (std::ranges::any_of(variables, is_same)) {
      name->Fail("there are two variables '" + name->word + "'; rename one");
    }
    variables.push_back({name->word, type});
  }
  return variables;
}

void Expect(const Expression& list, const std::string& word, int num_items,
            const std::string& form) {
  if (!list.BeginsWith(word) ||
      (num_items >= 0 &&
       list.items.size() != static_cast<size_t>(num_items) + 1)) {
    list.Fail("write " + form);
  }
}

const std::string& ReadName(const Expression& name, const std::string& what) {
  if (name.is_list) name.Fail("a list stands where the " + what + " should");
  if (!std::isalpha(static_cast<unsigned char>(name.word[0]))) {
    name.Fail("'" + name.word + "' is no " + what +
              ": names begin with a letter");
  }
  return name.word;
}

double ReadNumber(const Expression& word, double low, double high) {
  if (word.is_list) word.Fail("a list stands where a number should");
  const Result<double> number = ParseNumber(word.word);
  if (!number) {
    word.Fail("'" + word.word + "' " + number.reason() + "; write 0.25 or 1/4");
  }
  if (!(low <= *number && *number <= high)) {
    word.Fail(fmt::format("{} is not between {} and {}", word.word, low, high));
  }
  return *number;
}

}  // namespace cell::ppddl
