#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/relational/state.h"
#include "common/relational/vocabulary.h"

namespace cell {

/// An argument of a literal.
struct Term {
  enum class Kind {
    kVariable,  ///< index: place in the rule's variables
    kObject,    ///< index: of the vocabulary
    kAny        ///< `_`: some object; of a negated literal: none
  };
  Kind kind = Kind::kAny;
  int index = 0;
  bool operator==(const Term&) const = default;
};

/// A predicate or a static relation of terms, or its negation.
struct Literal {
  bool is_static = false;
  int relation = 0;  ///< index among predicates, or static relations
  std::vector<Term> terms;
  bool is_negated = false;
  bool operator==(const Literal&) const = default;
};

/// A variable of a rule; its name begins with a capital letter.
struct Variable {
  std::string name;
  int type;
  bool operator==(const Variable&) const = default;
};

/// Objects for the first variables of a rule, in their order.
using Binding = std::vector<int>;

/// Reads "X", "table.top" or "_": a term of the type or a narrower one.
/// @throws ConfigError for unknown words and wrong types.
Term ParseTerm(const Config& config, int type, const Vocabulary& vocabulary,
               std::span<const Variable> variables);

/// Reads "Clear(X)", "not On(_, X)", "fits(X, table.top)". Variables begin with
/// a capital letter, objects do not.
/// @throws ConfigError for unknown words, wrong types, wrong numbers of terms.
Literal ParseLiteral(const Config& config, const Vocabulary& vocabulary,
                     std::span<const Variable> variables);
/// True if they cannot both hold, whatever their variables stand for.
bool Contradict(const Literal& a, const Literal& b);
/// A list of them that can hold together.
/// @throws ConfigError also for one that is there twice or contradicts another.
std::vector<Literal> ParseLiterals(const Config& config,
                                   const Vocabulary& vocabulary,
                                   std::span<const Variable> variables);

/// True if the literal may hold: an unknown atom satisfies a literal and its
/// negation. Of a state that is known throughout: if it holds. False for
/// objects of a wrong type.
bool MayHold(const Literal& literal, const Binding& binding, const State& state,
             const Vocabulary& vocabulary);
bool MayHold(std::span<const Literal> literals, const Binding& binding,
             const State& state, const Vocabulary& vocabulary);
/// True only if no unknown atom could make it false.
bool MustHold(const Literal& literal, const Binding& binding,
              const State& state, const Vocabulary& vocabulary);

/// The ground atoms of the predicate literal, one unless it has `_`; none if an
/// object is of a wrong type.
std::vector<int> Groundings(const Literal& literal, const Binding& binding,
                            const Vocabulary& vocabulary);

/// "not On(X, _)", as ParseLiteral() reads it.
std::string ToText(const Literal& literal, const Vocabulary& vocabulary,
                   std::span<const Variable> variables);
/// "X"
std::string ToText(const Term& term, const Vocabulary& vocabulary,
                   std::span<const Variable> variables);

/// "not On(a, _)"
std::string Show(const Literal& literal, const Binding& binding,
                 const Vocabulary& vocabulary);

}  // namespace cell
