#include "common/rules/data_text.h"

#include <algorithm>

#include "common/rules/rule_error.h"
#include "common/rules/tokens.h"
#include "common/text/nearest.h"

namespace cell::rules {
namespace {

/// One ground atom of a line.
struct DataAtom {
  int symbol = 0;
  std::vector<std::string> objects;
  std::optional<int> value;
};

DataAtom ReadDataAtom(const SymbolTable& symbols, TokenReader& in) {
  DataAtom atom;
  const std::string name = in.Word("a predicate, function or action");
  const auto found = symbols.Find(name);
  if (!found) {
    in.Fail(
        fmt::format("there is no symbol '{}'{}", name,
                    NamesInstead(name, NamesIn(symbols.all(), &Symbol::name))));
  }
  atom.symbol = *found;
  const Symbol& symbol = symbols[*found];
  in.Expect("(");
  while (!in.TakeIf(")")) {
    atom.objects.push_back(in.Word("an object or ')'"));
    if (IsVariableName(atom.objects.back())) {
      in.Fail(
          fmt::format("'{}' should begin with a small letter or a digit: "
                      "capital letters begin variables",
                      atom.objects.back()));
    }
    in.TakeIf(",");
  }
  if (static_cast<int>(atom.objects.size()) != symbol.arity) {
    in.Fail(fmt::format("'{}' has {} arguments, not {}", name, symbol.arity,
                        atom.objects.size()));
  }
  if (in.TakeIf("=")) atom.value = in.Integer("a whole number");
  if (atom.value.has_value() != symbol.is_integer) {
    in.Fail(symbol.is_integer
                ? fmt::format("'{}' is a function: its value is missing, such "
                              "as {}(...)=1",
                              name, name)
                : fmt::format("'{}' is not a function: it has no value", name));
  }
  return atom;
}

struct DataLine {
  Place place;
  std::vector<DataAtom> atoms;
  bool is_action = false;
};

DataLine ReadDataLine(const TextLine& line, const SymbolTable& symbols) {
  DataLine data{line.place, {}, false};
  TokenReader in(line.text, line.place);
  while (!in.AtEnd()) {
    data.atoms.push_back(ReadDataAtom(symbols, in));
    const Symbol& symbol = symbols[data.atoms.back().symbol];
    data.is_action |= symbol.kind == Symbol::Kind::kAction;
  }
  if (data.is_action && data.atoms.size() != 1) {
    in.Fail("an action stands in a line of its own");
  }
  return data;
}

WorldState StateOf(const DataLine& line, const World& world) {
  WorldState state = world.EmptyState(false);
  for (int i = 0; i < world.num_constants(); ++i) {
    state.is_present[static_cast<size_t>(i)] = 1;
  }
  for (const DataAtom& atom : line.atoms) {
    std::vector<int> objects;
    for (const std::string& name : atom.objects) {
      const auto object = world.FindObject(name);
      if (!object) {
        line.place.Fail(fmt::format("there is no object '{}'{}", name,
                                    NamesInstead(name, world.objects())));
      }
      objects.push_back(*object);
      state.is_present[static_cast<size_t>(*object)] = 1;
    }
    const int place = world.PlaceOf(atom.symbol, objects);
    if (!atom.value) {
      World::Set(&state, place, true);
      continue;
    }
    int& value = state.values[static_cast<size_t>(place)];
    if (value != World::kNoValue && value != *atom.value) {
      line.place.Fail(fmt::format("{} is {} and {}",
                                  world.Show(atom.symbol, objects), value,
                                  *atom.value));
    }
    value = *atom.value;
  }
  world.Derive(&state);
  return state;
}

GroundAct ActOf(const DataLine& line, const World& world,
                const WorldState& before) {
  GroundAct act{line.atoms[0].symbol, {}};
  for (const std::string& name : line.atoms[0].objects) {
    const auto object = world.FindObject(name);
    if (!object || !before.is_present[static_cast<size_t>(*object)]) {
      line.place.Fail("the state before says nothing of '" + name + "'");
    }
    act.arguments.push_back(*object);
  }
  return act;
}

std::vector<std::string> ObjectNames(const std::vector<DataLine>& lines) {
  std::vector<std::string> names;
  for (const DataLine& line : lines) {
    for (const DataAtom& atom : line.atoms) {
      for (const std::string& name : atom.objects) {
        if (std::ranges::count(names, name) == 0) names.push_back(name);
      }
    }
  }
  return names;
}

void AppendAtoms(const WorldState& state, const World& world, int symbol,
                 std::string* text) {
  for (int i = 0; i < world.num_places(symbol); ++i) {
    const int place = world.first(symbol) + i;
    const bool is_integer = world.symbols()[symbol].is_integer;
    const int value = is_integer ? state.values[static_cast<size_t>(place)] : 0;
    if (is_integer ? value == World::kNoValue : !World::Get(state, place)) {
      continue;
    }
    if (!text->empty()) *text += " ";
    *text += world.Show(symbol, world.ObjectsAt(symbol, place));
    if (is_integer) *text += fmt::format("={}", value);
  }
}

}  // namespace

WorldState ParseState(const std::string& text, const std::string& file,
                      int line, const World& world) {
  const DataLine data = ReadDataLine({{file, line}, text}, world.symbols());
  if (data.is_action) data.place.Fail("expected a state, not an action");
  return StateOf(data, world);
}

ExperienceSet ParseExperiences(const std::string& text, const std::string& file,
                               std::shared_ptr<const SymbolTable> symbols) {
  std::vector<DataLine> lines;
  for (const TextLine& line : SplitLines(text, file)) {
    if (line.text.find_first_not_of(" \t") == std::string::npos) continue;
    lines.push_back(ReadDataLine(line, *symbols));
  }
  ExperienceSet set;
  set.world = std::make_shared<World>(std::move(symbols), ObjectNames(lines));
  std::optional<WorldState> before;
  std::optional<GroundAct> act;
  for (const DataLine& line : lines) {
    if (line.is_action) {
      if (!before || act) {
        line.place.Fail("an action follows the state before it");
      }
      act = ActOf(line, *set.world, *before);
      continue;
    }
    WorldState state = StateOf(line, *set.world);
    if (act) set.experiences.push_back({*before, *act, state});
    act.reset();
    before = std::move(state);
  }
  if (act) lines.back().place.Fail("the state after this action is missing");
  return set;
}

std::string ToText(const WorldState& state, const World& world) {
  std::string text;
  for (size_t i = 0; i < world.symbols().all().size(); ++i) {
    const Symbol& symbol = world.symbols().all()[i];
    if (symbol.kind != Symbol::Kind::kPrimitive) continue;
    AppendAtoms(state, world, static_cast<int>(i), &text);
  }
  return text;
}

std::string ToText(const ExperienceSet& set) {
  std::string text;
  const WorldState* last = nullptr;
  for (const Experience& e : set.experiences) {
    if (last == nullptr || *last != e.before) {
      text += ToText(e.before, *set.world) + "\n";
    }
    text += set.world->Show(e.act.action, e.act.arguments) + "\n";
    text += ToText(e.after, *set.world) + "\n";
    last = &e.after;
  }
  return text;
}

}  // namespace cell::rules
