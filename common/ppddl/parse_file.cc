#include "common/ppddl/parse_file.h"

#include <algorithm>

#include "common/ppddl/scope.h"
#include "common/text/nearest.h"

namespace cell::ppddl {
namespace {

const std::vector<std::string> kSupported = {
    ":strips", ":typing", ":equality", ":negative-preconditions",
    ":disjunctive-preconditions", ":existential-preconditions",
    ":universal-preconditions", ":quantified-preconditions",
    ":conditional-effects", ":adl", ":probabilistic-effects", ":rewards",
    ":mdp", ":action-costs",
    // Domains declare it for costs; what else it allows is refused in place.
    ":fluents", ":numeric-fluents"};

const std::vector<std::string> kUnsupported = {
    ":durative-actions",   ":duration-inequalities",  ":continuous-effects",
    ":derived-predicates", ":timed-initial-literals", ":preferences",
    ":constraints",        ":object-fluents",         ":time",
    ":goal-utilities",     ":non-deterministic",      ":partial-observability"};

bool Has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

const Expression& FindDefine(const std::vector<Expression>& expressions,
                             const std::string& kind, const std::string& file) {
  const std::string form = "(define (" + kind + " name) ...)";
  const Expression* found = nullptr;
  for (const Expression& expression : expressions) {
    if (!expression.BeginsWith("define")) expression.Fail("write " + form);
    if (expression.items.size() < 2) expression.Fail("write " + form);
    const Expression& header = expression.items[1];
    if (!header.BeginsWith(kind)) continue;
    Expect(header, kind, 1, "(" + kind + " name)");
    if (found != nullptr) expression.Fail("the file defines two " + kind + "s");
    found = &expression;
  }
  if (found == nullptr) {
    throw PpddlError(file + ":1:1: defines no " + kind + "; write " + form);
  }
  return *found;
}

void CheckSections(const Expression& define,
                   const std::vector<std::string>& sections) {
  for (size_t i = 2; i < define.items.size(); ++i) {
    const Expression& section = define.items[i];
    if (!section.is_list || section.items.empty()) {
      section.Fail("write a section, as (" + sections.front() + " ...)");
    }
    if (Has(sections, section.Head())) continue;
    if (section.Head() == ":derived" || section.Head() == ":durative-action" ||
        section.Head() == ":constraints") {
      section.Fail(section.Head() + " is not supported");
    }
    section.items.front().Fail("there is no section '" + section.Head() + "'" +
                               NamesInstead(section.Head(), sections));
  }
}

std::vector<std::string> ReadRequirements(const Expression& section) {
  std::vector<std::string> requirements;
  for (size_t i = 1; i < section.items.size(); ++i) {
    const Expression& item = section.items[i];
    if (item.is_list) item.Fail("a list stands where a requirement should");
    if (Has(kUnsupported, item.word)) {
      item.Fail("the requirement " + item.word + " is not supported");
    }
    if (!Has(kSupported, item.word)) {
      item.Fail("there is no requirement '" + item.word + "'" +
                NamesInstead(item.word, kSupported));
    }
    if (!Has(requirements, item.word)) requirements.push_back(item.word);
  }
  return requirements;
}

}  // namespace cell::ppddl
