#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cell::rules {

/// Most arguments of a symbol.
inline constexpr int kMaxArity = 3;

/// What a derived symbol is defined by, and what the arguments of an action
/// have to be. Variables are indices: first those of the symbol's arguments,
/// named X, Y, Z, then the quantified ones.
struct Definition {
  struct Atom {
    int symbol = 0;
    std::vector<int> variables;
    bool is_negated = false;
    bool operator==(const Atom&) const = default;
  };
  std::vector<Atom> atoms;
  std::vector<std::string> variables;
  bool is_for_all = false;  ///< the quantified variables; false: there are some
  int of = -1;              ///< closure, sum: of this symbol
  bool operator==(const Definition&) const = default;
};

struct Symbol {
  enum class Kind {
    kAction,
    kPrimitive,
    kConjunction,  ///< all atoms of the definition hold
    kClosure,      ///< transitive closure of a relation of two arguments
    kCount,        ///< number of bindings for which the definition holds
    kSum           ///< of a function, over all objects
  };
  std::string name;
  int arity = 0;
  Kind kind = Kind::kPrimitive;
  bool is_integer = false;
  Definition definition;
  bool operator==(const Symbol&) const = default;

  bool is_derived() const {
    return kind != Kind::kAction && kind != Kind::kPrimitive;
  }
  /// True or false in a state.
  bool is_predicate() const { return kind != Kind::kAction && !is_integer; }
  /// And not derived from others.
  bool is_primitive_predicate() const {
    return kind == Kind::kPrimitive && !is_integer;
  }
};

/// The symbols of a domain and the constants that rules may name, without the
/// objects of a scene. A symbol is defined by those before it only.
///
///   grab        1 action      binary   <-- block(X)
///   on          2 primitive   binary
///   size        1 primitive   integers
///   clear       1 conjunction binary   <-- All Y -on(Y X)
///   above       2 transclosure binary  <-- + on
///   height      1 count       integers <-- Num Y above(X Y)
///   sum_height  0 sum         integers <-- Sum height
///   tray        0 constant
///
/// The condition of an action is optional: it restricts what its arguments may
/// be (their types), and is part of no rule.
class SymbolTable {
 public:
  SymbolTable() = default;

  /// `name` and `first_line` stand in errors for where the text comes from.
  /// @throws RuleError "name:line: ..."
  static SymbolTable Parse(const std::string& text, const std::string& name,
                           int first_line = 1);

  const std::vector<Symbol>& all() const { return all_; }
  const Symbol& operator[](int symbol) const {
    return all_.at(static_cast<size_t>(symbol));
  }
  const std::vector<std::string>& constants() const { return constants_; }
  std::optional<int> Find(const std::string& name) const;
  /// The symbols of a kind, ascending.
  std::vector<int> Actions() const;

  /// The symbols when actions may have any objects.
  SymbolTable WithoutConditions() const;
  /// The declarations as Parse() reads them, one a line.
  std::string ToText() const;
  bool operator==(const SymbolTable&) const = default;

 private:
  friend class SymbolParser;
  std::vector<Symbol> all_;
  std::vector<std::string> constants_;
};

}  // namespace cell::rules
