#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "common/ppddl/domain.h"
#include "common/ppddl/parse_file.h"
#include "common/ppddl/parse_formula.h"
#include "common/text/nearest.h"

namespace cell::ppddl {
namespace {

const std::vector<std::string> kDomainSections = {
    ":requirements", ":types",     ":constants",
    ":predicates",   ":functions", ":action"};

/// @throws PpddlError for a name that another element has
template <class T>
void CheckIsNew(const Expression& name, const std::vector<T>& known,
                const std::string& what) {
  if (std::ranges::find(known, name.word, &T::name) != known.end()) {
    name.Fail("there are two " + what + "s '" + name.word + "'; rename one");
  }
}

/// Every type must lead to object.
void CheckAcyclic(const Domain& domain, const Expression& section) {
  for (size_t i = 1; i < domain.types.size(); ++i) {
    size_t at = i;
    for (size_t steps = 0; at != 0; ++steps) {
      if (steps == domain.types.size()) {
        section.Fail("the type '" + domain.types[i].name +
                     "' is its own ancestor; types must form a tree");
      }
      at = static_cast<size_t>(domain.types[at].parent);
    }
  }
}

void ParseTypes(const Expression& section, Domain* domain) {
  // Parents may come later, or only as a parent.
  for (size_t i = 1; i < section.items.size(); ++i) {
    const Expression& item = section.items[i];
    if (item.BeginsWith("either")) {
      item.Fail("(either ...) is not supported; declare a common parent type");
    }
    if (item.Is("-")) continue;
    ReadName(item, "type");
    const auto it = std::ranges::find(domain->types, item.word, &Type::name);
    if (it == domain->types.end()) domain->types.push_back({item.word, 0});
  }
  std::set<std::string> declared;
  for (const auto& [name, type] : ReadTypedNames(section, 1, Scope(*domain))) {
    if (!declared.insert(name->word).second) {
      name->Fail("the type '" + name->word + "' is declared twice");
    }
    if (name->word == "object" && type != 0) {
      name->Fail("'object' is the ancestor of all types");
    }
    std::ranges::find(domain->types, name->word, &Type::name)->parent = type;
  }
  CheckAcyclic(*domain, section);
}

Symbol ParseSymbol(const Expression& list, const Scope& scope) {
  if (!list.is_list || list.items.empty()) {
    list.Fail("write (name ?x - type)");
  }
  return {ReadName(list.items.front(), "name"), ReadVariables(list, 1, scope)};
}

void ParsePredicates(const Expression& section, Domain* domain) {
  const Scope scope(*domain);
  for (size_t i = 1; i < section.items.size(); ++i) {
    Symbol symbol = ParseSymbol(section.items[i], scope);
    CheckIsNew(section.items[i].items.front(), domain->predicates, "predicate");
    domain->predicates.push_back(std::move(symbol));
  }
}

void ParseFunctions(const Expression& section, Domain* domain) {
  const Scope scope(*domain);
  for (size_t i = 1; i < section.items.size(); ++i) {
    const Expression& item = section.items[i];
    if (item.Is("-")) {
      if (++i == section.items.size() || !section.items[i].Is("number")) {
        item.Fail("write - number; other functions are not supported");
      }
      continue;
    }
    Symbol symbol = ParseSymbol(item, scope);
    CheckIsNew(item.items.front(), domain->functions, "function");
    domain->functions.push_back(std::move(symbol));
  }
}

/// Those that metrics and rewards use without being declared.
void AddUsualFunctions(Domain* domain) {
  for (const char* name : {"total-cost", "reward"}) {
    const bool is_there =
        std::ranges::find(domain->functions, name, &Symbol::name) !=
        domain->functions.end();
    if (!is_there) domain->functions.push_back({name, {}});
  }
}

Action ParseAction(const Expression& section, const Domain& domain) {
  if (section.items.size() < 2) section.Fail("write (:action name ...)");
  CheckIsNew(section.items[1], domain.actions, "action");
  Action action{ReadName(section.items[1], "action"), {}, {}, {}};
  std::map<std::string, const Expression*> parts;
  for (size_t i = 2; i < section.items.size(); i += 2) {
    const Expression& key = section.items[i];
    const std::vector<std::string> known = {":parameters", ":precondition",
                                            ":effect"};
    if (key.is_list || std::ranges::find(known, key.word) == known.end()) {
      key.Fail("an action has no part '" + key.Head() + "'" +
               NamesInstead(key.Head(), known));
    }
    if (i + 1 == section.items.size()) key.Fail("nothing follows " + key.word);
    if (!parts.emplace(key.word, &section.items[i + 1]).second) {
      key.Fail("the action has two parts " + key.word);
    }
  }
  Scope scope(domain);
  if (parts.contains(":parameters")) {
    const Expression& list = *parts[":parameters"];
    if (!list.is_list) list.Fail("write :parameters (?x - type)");
    action.parameters = ReadVariables(list, 0, scope);
    scope.AddVariables(action.parameters);
  }
  if (parts.contains(":precondition")) {
    action.precondition = ParseCondition(*parts[":precondition"], scope);
  }
  if (parts.contains(":effect")) {
    action.effect = ParseEffect(*parts[":effect"], scope);
  }
  return action;
}

/// The section of this name, once at most.
const Expression* FindSection(const Expression& define,
                              const std::string& name) {
  const Expression* found = nullptr;
  for (size_t i = 2; i < define.items.size(); ++i) {
    if (!define.items[i].BeginsWith(name)) continue;
    if (found != nullptr) define.items[i].Fail("there are two of " + name);
    found = &define.items[i];
  }
  return found;
}

}  // namespace

Domain ParseDomain(std::string_view text, const std::string& file) {
  const std::vector<Expression> expressions = ReadExpressions(text, file);
  const Expression& define = FindDefine(expressions, "domain", file);
  Domain domain;
  domain.name = ReadName(define.items[1].items[1], "domain");
  CheckSections(define, kDomainSections);
  // Sections may stand in any order.
  const auto parse = [&](const char* name, auto reader) {
    const Expression* section = FindSection(define, name);
    if (section != nullptr) reader(*section, &domain);
  };
  parse(":requirements", [](const Expression& section, Domain* to) {
    to->requirements = ReadRequirements(section);
  });
  parse(":types", ParseTypes);
  parse(":constants", [](const Expression& section, Domain* to) {
    for (const auto& [name, type] : ReadTypedNames(section, 1, Scope(*to))) {
      CheckIsNew(*name, to->constants, "constant");
      to->constants.push_back({ReadName(*name, "constant"), type});
    }
  });
  parse(":predicates", ParsePredicates);
  parse(":functions", ParseFunctions);
  AddUsualFunctions(&domain);
  for (size_t i = 2; i < define.items.size(); ++i) {
    if (!define.items[i].BeginsWith(":action")) continue;
    domain.actions.push_back(ParseAction(define.items[i], domain));
  }
  return domain;
}

bool Domain::IsA(int type, int ancestor) const {
  while (type != ancestor && type != 0) {
    type = types[static_cast<size_t>(type)].parent;
  }
  return type == ancestor;
}

}  // namespace cell::ppddl
