#include "common/rexd/ppddl_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "common/ppddl/parse_file.h"
#include "common/ppddl/problem.h"
#include "common/rexd/ppddl_rule.h"
#include "common/rules/symbols.h"
#include "common/rules/tokens.h"

namespace cell::rexd {
namespace {

bool IsOneWord(const std::string& name) {
  rules::TokenReader reader(name, {"", 0});
  reader.Next();
  return reader.AtEnd();
}

/// A domain, and the text that errors point into.
class DomainImport {
 public:
  explicit DomainImport(const PpddlText& text)
      : domain_(ppddl::ParseDomain(text.text, text.file)),
        expressions_(ppddl::ReadExpressions(text.text, text.file)),
        define_(ppddl::FindDefine(expressions_, "domain", text.file)) {}

  const ppddl::Domain& domain() const { return domain_; }

  std::string Rules() const {
    std::string text;
    std::string rules;
    std::set<std::string> names = {"nothing", "noise", "none", "not"};
    for (const ppddl::Object& constant : domain_.constants) {
      CheckName(constant.name, define_, ":constants", &names);
      text += constant.name + " 0 constant\n";
    }
    for (size_t i = 1; i < domain_.types.size(); ++i) {
      CheckName(domain_.types[i].name, define_, ":types", &names);
      text += domain_.types[i].name + " 1 primitive\n";
    }
    for (const ppddl::Symbol& predicate : domain_.predicates) {
      CheckName(predicate.name, define_, ":predicates", &names);
      CheckArity(predicate);
      text += fmt::format("{} {} primitive\n", predicate.name,
                          predicate.parameters.size());
    }
    for (const ppddl::Action& action : domain_.actions) {
      CheckName(action.name, define_, ":action", &names);
      const PpddlRule rule(domain_, action, PlaceOf(action.name));
      text += rule.Declaration();
      rules += rule.Text();
    }
    return text + rules;
  }

  /// Names of all that the domain declares, and words of rules.
  std::set<std::string> names() const {
    std::set<std::string> names = {"nothing", "noise", "none", "not"};
    const auto add = [&](const auto& named) {
      for (const auto& element : named) names.insert(element.name);
    };
    add(domain_.constants);
    add(domain_.types);
    add(domain_.predicates);
    add(domain_.actions);
    return names;
  }

  /// Names of rules are read as one word, and each is used once.
  static void CheckName(const std::string& name,
                        const ppddl::Expression& define,
                        const std::string& section,
                        std::set<std::string>* names) {
    if (!IsOneWord(name)) {
      FailAt(define, section,
             "the name '" + name + "' is no word of rules; rename it");
    }
    if (!names->insert(name).second) {
      FailAt(define, section,
             "'" + name +
                 "' is used for something else, too; rules tell types, "
                 "predicates, actions and objects apart by their names");
    }
  }

 private:
  void CheckArity(const ppddl::Symbol& predicate) const {
    if (predicate.parameters.size() <= static_cast<size_t>(rules::kMaxArity)) {
      return;
    }
    FailAt(define_, predicate.name,
           fmt::format("'{}' has {} arguments; rules have at most {}",
                       predicate.name, predicate.parameters.size(),
                       rules::kMaxArity));
  }

  const ppddl::Expression& PlaceOf(const std::string& action) const {
    for (const ppddl::Expression& item : define_.items) {
      if (item.BeginsWith(":action") && item.items[1].Is(action)) return item;
    }
    return define_;
  }

  ppddl::Domain domain_;
  std::vector<ppddl::Expression> expressions_;
  const ppddl::Expression& define_;
};

/// The lines of a task that come before its rules.
std::string ProblemLines(const DomainImport& import, const PpddlText& text) {
  const ppddl::Domain& domain = import.domain();
  const auto problem = ppddl::ParseProblem(text.text, text.file, domain);
  const auto expressions = ppddl::ReadExpressions(text.text, text.file);
  const ppddl::Expression& define =
      ppddl::FindDefine(expressions, "problem", text.file);
  std::vector<ppddl::Object> objects = domain.constants;
  std::string lines = "objects:";
  std::set<std::string> names = import.names();
  for (ppddl::Object object : problem.objects) {
    // A hyphen before a digit would end the word: l-1-2.
    if (!IsOneWord(object.name)) std::ranges::replace(object.name, '-', '_');
    import.CheckName(object.name, define, ":objects", &names);
    lines += " " + object.name;
    objects.push_back(object);
  }
  const auto atom = [&](int predicate, const std::vector<int>& places) {
    std::vector<std::string> arguments;
    for (const int i : places) {
      arguments.push_back(objects[static_cast<size_t>(i)].name);
    }
    return fmt::format("{}({})",
                       domain.predicates[static_cast<size_t>(predicate)].name,
                       fmt::join(arguments, " "));
  };
  lines += "\nstart:";
  for (const ppddl::Object& object : objects) {
    for (int type = object.type; type != 0;
         type = domain.types[static_cast<size_t>(type)].parent) {
      lines += fmt::format(
          " {}({})", domain.types[static_cast<size_t>(type)].name, object.name);
    }
  }
  for (const ppddl::GroundAtom& init : problem.init) {
    lines += " " + atom(init.predicate, init.objects);
  }
  std::vector<ppddl::Condition> goals = {problem.goal};
  if (problem.goal.kind == ppddl::Condition::Kind::kAnd)
    goals = problem.goal.parts;
  lines += "\ngoal:";
  for (const ppddl::Condition& goal : goals) {
    const bool is_negated = goal.kind == ppddl::Condition::Kind::kNot;
    const ppddl::Condition& inner = is_negated ? goal.parts[0] : goal;
    if (inner.kind != ppddl::Condition::Kind::kAtom) {
      FailAt(define, ":goal", "the goal of rules is a conjunction of literals");
    }
    std::vector<int> places;
    for (const ppddl::Term& term : inner.terms) places.push_back(term.index);
    lines +=
        std::string(is_negated ? " -" : " ") + atom(inner.predicate, places);
  }
  return lines + "\n\n";
}

}  // namespace

std::string RulesOfPpddl(const PpddlText& domain) {
  return DomainImport(domain).Rules();
}

std::string TaskOfPpddl(const PpddlText& domain, const PpddlText& problem) {
  const DomainImport import(domain);
  return ProblemLines(import, problem) + import.Rules();
}

}  // namespace cell::rexd
