#include <map>
#include <set>
#include <string>

#include "common/ppddl/parse_file.h"
#include "common/ppddl/parse_formula.h"
#include "common/ppddl/problem.h"

namespace cell::ppddl {
namespace {

const std::vector<std::string> kProblemSections = {
    ":domain", ":requirements", ":objects", ":init",
    ":goal",   ":goal-reward",  ":metric",  ":length"};

std::vector<int> ObjectsOf(const std::vector<Term>& terms) {
  std::vector<int> objects;
  for (const Term& term : terms) objects.push_back(term.index);
  return objects;
}

FunctionValue ParseValue(const Expression& item, const Scope& scope) {
  if (item.items.size() != 3 || !item.items[1].is_list ||
      item.items[1].items.empty()) {
    item.Fail("write (= (function) number)");
  }
  const Expression& left = item.items[1];
  FunctionValue value;
  value.function = scope.FunctionOf(left.items.front());
  const Symbol& function =
      scope.domain().functions[static_cast<size_t>(value.function)];
  value.objects = ObjectsOf(scope.ArgumentsOf(left, function));
  value.value = ReadNumber(item.items[2], -kMaxNumber, kMaxNumber);
  return value;
}

GroundAtom ParseGroundAtom(const Expression& item, const Scope& scope) {
  GroundAtom atom;
  atom.predicate = scope.PredicateOf(item.items.front());
  const Symbol& predicate =
      scope.domain().predicates[static_cast<size_t>(atom.predicate)];
  atom.objects = ObjectsOf(scope.ArgumentsOf(item, predicate));
  return atom;
}

void ParseInit(const Expression& section, const Scope& scope,
               Problem* problem) {
  std::set<GroundAtom> known;
  for (size_t i = 1; i < section.items.size(); ++i) {
    const Expression& item = section.items[i];
    if (!item.is_list || item.items.empty()) {
      item.Fail("write an atom, as (on a b)");
    }
    if (item.BeginsWith("=")) {
      problem->values.push_back(ParseValue(item, scope));
    } else if (item.BeginsWith("probabilistic")) {
      item.Fail("a probabilistic initial state is not supported");
    } else if (item.BeginsWith("not")) {
      // What is not listed is false.
      Expect(item, "not", 1, "(not (atom))");
      const GroundAtom atom = ParseGroundAtom(item.items[1], scope);
      if (known.contains(atom)) item.Fail("the atom is listed as true, too");
    } else {
      GroundAtom atom = ParseGroundAtom(item, scope);
      if (known.insert(atom).second) problem->init.push_back(std::move(atom));
    }
  }
}

Metric ParseMetric(const Expression& section, const Scope& scope) {
  const std::string form = "(:metric minimize (total-cost))";
  Expect(section, ":metric", 2, form);
  Metric metric;
  metric.is_maximized = section.items[1].Is("maximize");
  if (!metric.is_maximized && !section.items[1].Is("minimize")) {
    section.items[1].Fail("write " + form);
  }
  const Expression& what = section.items[2];
  if (what.is_list && what.items.size() != 1) {
    what.Fail("only one function can be optimised: " + form);
  }
  metric.function = scope.FunctionOf(what.is_list ? what.items[0] : what);
  return metric;
}

class ProblemParser {
 public:
  ProblemParser(const Expression& define, const Domain& domain)
      : define_(define), domain_(domain), scope_(domain) {
    for (size_t i = 2; i < define.items.size(); ++i) {
      const Expression& section = define.items[i];
      if (!sections_.emplace(section.Head(), &section).second) {
        section.Fail("there are two of " + section.Head());
      }
    }
  }

  Problem Parse() {
    problem_.name = ReadName(define_.items[1].items[1], "problem");
    ParseDomainName(Required(":domain"));
    if (const Expression* section = Find(":requirements")) {
      problem_.requirements = ReadRequirements(*section);
    }
    if (const Expression* section = Find(":objects")) ParseObjects(*section);
    if (const Expression* section = Find(":init")) {
      ParseInit(*section, scope_, &problem_);
    }
    Expect(Required(":goal"), ":goal", 1, "(:goal condition)");
    problem_.goal = ParseCondition(Required(":goal").items[1], scope_);
    if (const Expression* section = Find(":goal-reward")) {
      Expect(*section, ":goal-reward", 1, "(:goal-reward 100)");
      problem_.goal_reward =
          ReadNumber(section->items[1], -kMaxNumber, kMaxNumber);
    }
    if (const Expression* section = Find(":metric")) {
      problem_.metric = ParseMetric(*section, scope_);
    }
    return std::move(problem_);
  }

 private:
  const Expression* Find(const std::string& name) const {
    const auto it = sections_.find(name);
    return it == sections_.end() ? nullptr : it->second;
  }
  const Expression& Required(const std::string& name) const {
    const Expression* section = Find(name);
    if (section == nullptr) define_.Fail("(" + name + " ...) is missing");
    return *section;
  }

  void ParseDomainName(const Expression& section) {
    Expect(section, ":domain", 1, "(:domain " + domain_.name + ")");
    problem_.domain_name = ReadName(section.items[1], "domain");
    if (problem_.domain_name != domain_.name) {
      section.items[1].Fail("the problem is of the domain '" +
                            problem_.domain_name + "', not of '" +
                            domain_.name + "'");
    }
  }

  void ParseObjects(const Expression& section) {
    for (const auto& [name, type] : ReadTypedNames(section, 1, scope_)) {
      problem_.objects.push_back({ReadName(*name, "object"), type});
      scope_.AddObject(problem_.objects.back(), *name);
    }
  }

  const Expression& define_;
  const Domain& domain_;
  Scope scope_;
  std::map<std::string, const Expression*> sections_;
  Problem problem_;
};

}  // namespace

Problem ParseProblem(std::string_view text, const std::string& file,
                     const Domain& domain) {
  const std::vector<Expression> expressions = ReadExpressions(text, file);
  const Expression& define = FindDefine(expressions, "problem", file);
  CheckSections(define, kProblemSections);
  return ProblemParser(define, domain).Parse();
}

}  // namespace cell::ppddl
