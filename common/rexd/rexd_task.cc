#include "common/rexd/rexd_task.h"

#include <algorithm>
#include <map>

#include "common/rules/data_text.h"
#include "common/rules/rule_error.h"
#include "common/rules/rule_text.h"
#include "common/rules/tokens.h"

namespace cell::rexd {

using namespace rules;
namespace {

/// Ground literals: "on(a b) -clear(a)".
std::vector<Literal> ReadLiterals(const std::string& text, const Place& place,
                                  const World& world) {
  std::vector<Literal> literals;
  TokenReader in(text, place);
  while (!in.AtEnd()) {
    Literal literal;
    literal.comparison =
        in.TakeIf("-") ? Comparison::kFalse : Comparison::kTrue;
    const std::string name = in.Word("a predicate");
    const auto symbol = world.symbols().Find(name);
    if (!symbol || world.symbols()[*symbol].is_integer ||
        world.symbols()[*symbol].kind == Symbol::Kind::kAction) {
      in.Fail("there is no predicate '" + name + "'");
    }
    literal.symbol = *symbol;
    in.Expect("(");
    while (!in.TakeIf(")")) {
      const std::string object = in.Word("an object");
      const auto index = world.FindObject(object);
      if (!index) in.Fail("there is no object '" + object + "'");
      literal.terms.push_back({Term::Kind::kObject, *index});
      in.TakeIf(",");
    }
    if (static_cast<int>(literal.terms.size()) !=
        world.symbols()[*symbol].arity) {
      in.Fail(fmt::format("'{}' has {} arguments, not {}", name,
                          world.symbols()[*symbol].arity,
                          literal.terms.size()));
    }
    literals.push_back(std::move(literal));
  }
  return literals;
}

std::vector<Literal> ReadGoal(const TextLine& line, const World& world) {
  std::vector<Literal> goal = ReadLiterals(line.text, line.place, world);
  if (goal.empty()) line.place.Fail("the goal is empty");
  for (Literal literal : goal) {
    literal.comparison = Opposite(literal.comparison, &literal.value);
    if (std::ranges::count(goal, literal) == 0) continue;
    line.place.Fail("the goal wants '" + world.symbols()[literal.symbol].name +
                    "' to hold and not to hold of the same objects");
  }
  return goal;
}

/// Makes the literals true in the state. @throws RuleError naming one that is
/// derived from others
void Change(const TextLine& line, const World& world, WorldState* state) {
  for (const Literal& literal : ReadLiterals(line.text, line.place, world)) {
    const Symbol& symbol = world.symbols()[literal.symbol];
    if (!symbol.is_primitive_predicate()) {
      line.place.Fail("'" + symbol.name + "' follows from others");
    }
    std::vector<int> objects;
    for (const Term& term : literal.terms) objects.push_back(term.index);
    World::Set(state, world.PlaceOf(literal.symbol, objects),
               literal.comparison == Comparison::kTrue);
  }
  world.Derive(state);
}

/// Moves the lines that begin with one of the keys and a colon out of the text;
/// empty lines stay in their places.
std::map<std::string, TextLine> TakeSections(
    const std::string& text, const std::string& file,
    const std::vector<std::string>& keys, std::string* rest) {
  std::map<std::string, TextLine> sections;
  for (TextLine& line : SplitLines(text, file)) {
    const size_t colon = line.text.find(':');
    const std::string key = line.text.substr(0, colon);
    const bool is_section = colon != std::string::npos &&
                            std::ranges::find(keys, key) != keys.end();
    *rest += is_section ? "\n" : line.text + "\n";
    if (!is_section) continue;
    line.text = line.text.substr(colon + 1);
    if (!sections.emplace(key, line).second) {
      line.place.Fail("'" + key + ":' is there twice");
    }
  }
  return sections;
}

std::vector<std::string> ReadObjects(const TextLine& line) {
  TokenReader in(line.text, line.place);
  std::vector<std::string> objects;
  while (!in.AtEnd()) {
    objects.push_back(in.Word("the name of an object"));
    if (IsVariableName(objects.back())) {
      in.Fail("'" + objects.back() + "' should begin with a small letter");
    }
    if (std::ranges::count(objects, objects.back()) > 1) {
      in.Fail("'" + objects.back() + "' is there twice");
    }
  }
  return objects;
}

}  // namespace

bool RexdTask::IsGoal(const WorldState& state) const {
  return std::ranges::all_of(goal, [&](const Literal& literal) {
    return Holds(literal, {}, state, *world);
  });
}

RexdTask ParseRexdTask(const std::string& text, const std::string& file) {
  std::string rest;
  const std::map<std::string, TextLine> sections =
      TakeSections(text, file, {"objects", "start", "goal"}, &rest);
  for (const TextLine& line : SplitLines(rest, file)) {
    const size_t begin = line.text.find_first_not_of(" \t");
    if (begin != std::string::npos &&
        line.text.compare(begin, 5, "each ") == 0) {
      line.place.Fail("the rules of a task have no effects for each object");
    }
  }
  for (const char* key : {"objects", "start", "goal"}) {
    if (!sections.contains(key)) {
      throw RuleError(file, 1, fmt::format("a line '{}: ...' is missing", key));
    }
  }
  RexdTask task;
  task.truth = ParseRules(rest, file);
  task.world = std::make_shared<World>(task.truth.symbols,
                                       ReadObjects(sections.at("objects")));
  const TextLine& start = sections.at("start");
  task.initial = ParseState(start.text, file, start.place.line, *task.world);
  std::ranges::fill(task.initial.is_present, 1);
  task.world->Derive(&task.initial);
  task.goal = ReadGoal(sections.at("goal"), *task.world);
  return task;
}

RexdTask ParseChangedTask(const RexdTask& task, const std::string& text,
                          const std::string& file) {
  std::string rest;
  const std::map<std::string, TextLine> sections =
      TakeSections(text, file, {"changes", "goal"}, &rest);
  for (const TextLine& line : SplitLines(rest, file)) {
    if (line.text.find_first_not_of(" \t") == std::string::npos) continue;
    line.place.Fail("expected 'changes: ...' or 'goal: ...'");
  }
  RexdTask changed = task;
  if (const auto it = sections.find("changes"); it != sections.end()) {
    Change(it->second, *task.world, &changed.initial);
  }
  if (const auto it = sections.find("goal"); it != sections.end()) {
    changed.goal = ReadGoal(it->second, *task.world);
  }
  return changed;
}

RexdTask WithoutPredicate(const RexdTask& task, const std::string& predicate) {
  const World& world = *task.world;
  const auto symbol = world.symbols().Find(predicate);
  const auto speaks = [&](const std::vector<Literal>& literals) {
    return std::ranges::count(literals, *symbol, &Literal::symbol) > 0;
  };
  if (!symbol || !world.symbols()[*symbol].is_primitive_predicate()) {
    throw RuleError("the task", 0,
                    fmt::format("there is no predicate '{}'", predicate));
  }
  bool is_needed = speaks(task.goal);
  for (const Rule& rule : task.truth.rules) {
    is_needed |= speaks(rule.context);
    for (const auto& r : rule.references) is_needed |= speaks(r.literals);
    for (const auto& outcome : rule.outcomes) {
      is_needed |= speaks(outcome.changes);
    }
  }
  if (is_needed) {
    throw RuleError("the task", 0,
                    fmt::format("its rules need '{}'", predicate));
  }
  RexdTask hidden = task;
  for (int i = 0; i < world.num_places(*symbol); ++i) {
    World::Set(&hidden.initial, world.first(*symbol) + i, false);
  }
  world.Derive(&hidden.initial);
  return hidden;
}

RexdTask WithoutTypes(const RexdTask& task) {
  RexdTask untyped = task;
  for (Rule& rule : untyped.truth.rules) {
    const Definition& condition = (*task.truth.symbols)[rule.action].definition;
    for (const Definition::Atom& atom : condition.atoms) {
      Literal literal{atom.symbol, {}, Comparison::kTrue, 0};
      if (atom.is_negated) literal.comparison = Comparison::kFalse;
      for (const int v : atom.variables) {
        literal.terms.push_back({Term::Kind::kVariable, v});
      }
      if (std::ranges::find(rule.context, literal) == rule.context.end()) {
        rule.context.push_back(std::move(literal));
      }
    }
  }
  untyped.truth.symbols = std::make_shared<const SymbolTable>(
      task.truth.symbols->WithoutConditions());
  std::vector<std::string> objects = task.world->objects();
  objects.erase(objects.begin(), objects.begin() + task.world->num_constants());
  untyped.world = std::make_shared<World>(untyped.truth.symbols, objects);
  return untyped;
}

NdrRules WithSuccess(const NdrRules& truth, double success) {
  NdrRules scaled = truth;
  for (Rule& rule : scaled.rules) {
    rule.noise = 1;
    for (Outcome& outcome : rule.outcomes) {
      if (!outcome.changes.empty()) outcome.probability *= success;
      rule.noise -= outcome.probability;
    }
    rule.noise = std::max(0.0, rule.noise);
  }
  return scaled;
}

}  // namespace cell::rexd
