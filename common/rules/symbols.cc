#include "common/rules/symbols.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/rules/named_fact.h"
#include "common/rules/tokens.h"
#include "common/text/nearest.h"

namespace cell::rules {
namespace {

struct KindName {
  Symbol::Kind kind;
  const char* name;
};
constexpr KindName kKindNames[] = {
    {Symbol::Kind::kAction, "action"},
    {Symbol::Kind::kPrimitive, "primitive"},
    {Symbol::Kind::kConjunction, "conjunction"},
    {Symbol::Kind::kClosure, "transclosure"},
    {Symbol::Kind::kCount, "count"},
    {Symbol::Kind::kSum, "sum"},
};
constexpr const char* kArgumentNames[] = {"X", "Y", "Z"};

}  // namespace

/// Reads one declaration after the other.
class SymbolParser {
 public:
  explicit SymbolParser(SymbolTable* table) : table_(table) {}

  void Read(const TextLine& line) {
    TokenReader in(line.text, line.place);
    if (in.AtEnd()) return;
    const std::string name = in.Word("the name of a symbol");
    const bool is_known = table_->Find(name).has_value() ||
                          std::ranges::count(table_->constants_, name) > 0;
    if (is_known) in.Fail(fmt::format("'{}' is declared twice", name));
    Symbol symbol;
    symbol.name = name;
    symbol.arity = in.Integer("the number of arguments");
    if (symbol.arity < 0 || symbol.arity > kMaxArity) {
      in.Fail(fmt::format("'{}' has {} arguments; 0 to {} are possible", name,
                          symbol.arity, kMaxArity));
    }
    const std::string kind = in.Word("the kind of a symbol");
    if (kind == "constant") return AddConstant(symbol, in);
    symbol.kind = KindOf(kind, in);
    if (!in.AtEnd() && in.Peek() != "<--") ReadValues(symbol, in);
    symbol.is_integer |= symbol.kind == Symbol::Kind::kCount ||
                         symbol.kind == Symbol::Kind::kSum;
    ReadDefinition(symbol, in);
    table_->all_.push_back(std::move(symbol));
  }

 private:
  void AddConstant(const Symbol& symbol, TokenReader& in) {
    if (symbol.arity != 0 || IsVariableName(symbol.name)) {
      in.Fail("a constant has no arguments and begins with a small letter");
    }
    if (!in.AtEnd()) in.Fail("nothing may follow 'constant'");
    table_->constants_.push_back(symbol.name);
  }

  static Symbol::Kind KindOf(const std::string& word, const TokenReader& in) {
    for (const KindName& entry : kKindNames) {
      if (word == entry.name) return entry.kind;
    }
    in.Fail(fmt::format(
        "'{}' is no kind of symbol{}", word,
        NamesInstead(word, {"action", "primitive", "conjunction",
                            "transclosure", "count", "sum", "constant"})));
  }

  static void ReadValues(Symbol& symbol, TokenReader& in) {
    const std::string values = in.Word("binary or integers");
    if (values != "binary" && values != "integers") {
      in.Fail(fmt::format("expected binary or integers, not '{}'", values));
    }
    symbol.is_integer = values == "integers";
    if (symbol.is_integer && (symbol.kind == Symbol::Kind::kAction ||
                              symbol.kind == Symbol::Kind::kConjunction ||
                              symbol.kind == Symbol::Kind::kClosure)) {
      in.Fail(fmt::format("'{}' can only be binary", symbol.name));
    }
  }

  void ReadDefinition(Symbol& symbol, TokenReader& in) {
    for (int i = 0; i < symbol.arity; ++i) {
      symbol.definition.variables.emplace_back(kArgumentNames[i]);
    }
    if (in.AtEnd()) {
      if (symbol.is_derived()) {
        in.Fail(fmt::format("'{}' needs a definition: <-- ...", symbol.name));
      }
      return;
    }
    if (symbol.kind == Symbol::Kind::kPrimitive) {
      in.Fail(
          fmt::format("'{}' is primitive: it has no definition", symbol.name));
    }
    in.Expect("<--");
    switch (symbol.kind) {
      case Symbol::Kind::kClosure:
        in.TakeIf("+");
        return ReadRelated(symbol, 2, false, in);
      case Symbol::Kind::kSum:
        in.Expect("Sum");
        return ReadRelated(symbol, 1, true, in);
      default:
        return ReadConjunction(symbol, in);
    }
  }

  /// The one symbol that a closure or a sum is taken of.
  void ReadRelated(Symbol& symbol, int arity, bool is_integer,
                   TokenReader& in) {
    const int of = SymbolOf(in);
    const Symbol& related = (*table_)[of];
    const int own_arity = symbol.kind == Symbol::Kind::kSum ? 0 : 2;
    if (related.arity != arity || related.is_integer != is_integer ||
        symbol.arity != own_arity || !in.AtEnd()) {
      in.Fail(fmt::format(
          "'{}' should be declared as: {}", symbol.name,
          is_integer ? "NAME 0 sum integers <-- Sum FUNCTION_OF_ONE_ARGUMENT"
                     : "NAME 2 transclosure binary <-- + RELATION_OF_TWO"));
    }
    symbol.definition.of = of;
  }

  void ReadConjunction(Symbol& symbol, TokenReader& in) {
    Definition& definition = symbol.definition;
    definition.is_for_all = in.Peek() == "All";
    for (const char* word : {"All", "Num", "Some"}) {
      if (in.Peek() == word && in.Peek(1) != "(") {
        in.Next();
        while (IsVariableName(in.Peek()) && in.Peek(1) != "(") {
          definition.variables.push_back(in.Next());
        }
      }
    }
    while (!in.AtEnd()) definition.atoms.push_back(ReadAtom(definition, in));
    if (definition.atoms.empty()) in.Fail("the definition is empty");
  }

  Definition::Atom ReadAtom(Definition& definition, TokenReader& in) {
    Definition::Atom atom;
    atom.is_negated = in.TakeIf("-");
    atom.symbol = SymbolOf(in);
    in.Expect("(");
    while (!in.TakeIf(")")) {
      const std::string name = in.Word("a variable");
      auto& known = definition.variables;
      auto it = std::ranges::find(known, name);
      if (it == known.end()) {
        if (!IsVariableName(name)) in.Fail("'" + name + "' is no variable");
        it = known.insert(known.end(), name);
      }
      atom.variables.push_back(static_cast<int>(it - known.begin()));
      in.TakeIf(",");
    }
    const Symbol& symbol = (*table_)[atom.symbol];
    if (symbol.is_integer ||
        symbol.arity != static_cast<int>(atom.variables.size())) {
      in.Fail(fmt::format("'{}' has {} arguments{}", symbol.name, symbol.arity,
                          symbol.is_integer ? " and is no predicate" : ""));
    }
    return atom;
  }

  int SymbolOf(TokenReader& in) {
    return FactNamed(in.Word("a symbol"), *table_, in, " before");
  }

  SymbolTable* table_;
};

SymbolTable SymbolTable::Parse(const std::string& text, const std::string& name,
                               int first_line) {
  SymbolTable table;
  SymbolParser parser(&table);
  for (const TextLine& line : SplitLines(text, name, first_line)) {
    parser.Read(line);
  }
  return table;
}

std::optional<int> SymbolTable::Find(const std::string& name) const {
  const auto it = std::ranges::find(all_, name, &Symbol::name);
  if (it == all_.end()) return std::nullopt;
  return static_cast<int>(it - all_.begin());
}

std::vector<int> SymbolTable::Actions() const {
  std::vector<int> actions;
  for (size_t i = 0; i < all_.size(); ++i) {
    if (all_[i].kind == Symbol::Kind::kAction) {
      actions.push_back(static_cast<int>(i));
    }
  }
  return actions;
}

SymbolTable SymbolTable::WithoutConditions() const {
  SymbolTable table = *this;
  for (Symbol& symbol : table.all_) {
    if (symbol.kind == Symbol::Kind::kAction) symbol.definition.atoms.clear();
  }
  return table;
}

std::string SymbolTable::ToText() const {
  std::string text;
  for (const std::string& constant : constants_) {
    text += constant + " 0 constant\n";
  }
  for (const Symbol& symbol : all_) {
    const char* kind = kKindNames[static_cast<int>(symbol.kind)].name;
    text += fmt::format("{} {} {} {}", symbol.name, symbol.arity, kind,
                        symbol.is_integer ? "integers" : "binary");
    const Definition& definition = symbol.definition;
    if (definition.of >= 0) {
      text += symbol.kind == Symbol::Kind::kSum ? " <-- Sum " : " <-- + ";
      text += (*this)[definition.of].name;
    }
    if (!definition.atoms.empty()) {
      text += " <--";
      const auto arity = static_cast<size_t>(symbol.arity);
      if (definition.variables.size() > arity) {
        text += symbol.kind == Symbol::Kind::kCount ? " Num"
                : definition.is_for_all             ? " All"
                                                    : " Some";
        for (size_t i = arity; i < definition.variables.size(); ++i) {
          text += " " + definition.variables[i];
        }
      }
    }
    for (const Definition::Atom& atom : definition.atoms) {
      text += atom.is_negated ? " -" : " ";
      text += (*this)[atom.symbol].name + "(";
      for (size_t i = 0; i < atom.variables.size(); ++i) {
        text += (i > 0 ? " " : "") +
                definition.variables[static_cast<size_t>(atom.variables[i])];
      }
      text += ")";
    }
    text += "\n";
  }
  return text;
}

}  // namespace cell::rules
