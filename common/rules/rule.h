#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/rules/world.h"

namespace cell::rules {

/// An argument of a literal.
struct Term {
  enum class Kind {
    kVariable,  ///< index: among the rule's variables
    kObject,    ///< index: among the world's objects
    kAny        ///< `_`
  };
  Kind kind = Kind::kAny;
  int index = 0;
  bool operator==(const Term&) const = default;
};

enum class Comparison : int8_t {
  kTrue,
  kFalse,
  kEqual,
  kNotEqual,
  kAtMost,
  kAtLeast
};
/// What holds exactly where `comparison` with the value does not; `value` is
/// changed where the comparison wants it.
Comparison Opposite(Comparison comparison, int* value);

/// Of a function's value, which may be World::kNoValue: nothing holds of that.
bool Compare(Comparison comparison, int value, int with);

/// A predicate that is true or false of its terms, or a function compared with
/// a number; as a change, what becomes true, or the value that it gets. `_` in
/// a term: some object; of a negated literal, none.
struct Literal {
  static constexpr int kSame = -1;  ///< symbol: both terms are one object

  int symbol = 0;
  std::vector<Term> terms;
  Comparison comparison = Comparison::kTrue;
  int value = 0;
  bool operator==(const Literal&) const = default;
};

/// A variable that stands for the one object for which all literals hold; if
/// there is none, or a second, the rule does not apply.
struct Reference {
  std::string variable;
  std::vector<Literal> literals;
  bool operator==(const Reference&) const = default;
};

/// A change for each object for which all of `where` held before the action.
/// In its literals that object is the variable after those of the rule.
struct QuantifiedChange {
  std::string variable;
  std::vector<Literal> where;
  Literal change;
  bool operator==(const QuantifiedChange&) const = default;
};

struct Outcome {
  double probability = 0;
  std::vector<Literal> changes;
  std::vector<QuantifiedChange> each = {};
  bool operator==(const Outcome&) const = default;
};

/// Noisy deictic rule (Pasula, Zettlemoyer, Kaelbling, JAIR 2007; the paper's
/// Fig. 10). Its variables are the action's arguments, then the references, in
/// their order. The probabilities of the outcomes and the noise sum to 1.
struct Rule {
  int action = 0;
  std::vector<std::string> arguments;  ///< names of the variables
  std::vector<Reference> references;
  std::vector<Literal> context;
  std::vector<Outcome> outcomes;
  double noise = 0;
  bool operator==(const Rule&) const = default;

  std::string VariableName(int index) const;
  int num_variables() const {
    return static_cast<int>(arguments.size() + references.size());
  }
  /// Literals of context, references and outcomes: PEN(r) of eq. (1).
  int num_literals() const;
  /// The rule with one variable more, as the literals of a QuantifiedChange
  /// name it.
  Rule WithVariable(const std::string& variable) const;
};

/// Rules of all actions. In a state one of them should cover an action; if none
/// or several do, nothing is known of it (the default rule).
struct NdrRules {
  std::shared_ptr<const SymbolTable> symbols;
  std::vector<Rule> rules;
};

/// An action with its objects.
struct GroundAct {
  int action = 0;
  std::vector<int> arguments;
  auto operator<=>(const GroundAct&) const = default;
};

/// @param binding  objects of the rule's variables, as far as terms name them
bool Holds(const Literal& literal, std::span<const int> binding,
           const WorldState& state, const World& world);

/// The objects of the rule's variables; nullopt if it does not cover the
/// action's objects in the state.
std::optional<std::vector<int>> Bind(const Rule& rule,
                                     std::span<const int> arguments,
                                     const WorldState& state,
                                     const World& world);

struct Coverage {
  const Rule* rule = nullptr;
  std::vector<int> binding;
};
/// The only rule that covers the action; nullopt if none or several do.
std::optional<Coverage> FindCoverage(const NdrRules& rules,
                                     const GroundAct& act,
                                     const WorldState& state,
                                     const World& world);

/// The state with the changes of an outcome, derived atoms included. Where they
/// contradict each other, those that are not quantified count.
WorldState Apply(const Outcome& outcome, std::span<const int> binding,
                 const WorldState& before, const World& world);

/// All actions with present objects for which the action's condition (types)
/// holds, in the order of actions and objects.
std::vector<GroundAct> GroundActs(const World& world, const WorldState& state);

}  // namespace cell::rules
