#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "common/rules/rule.h"
#include "common/rules/tokens.h"

namespace cell::rules {

/// What may stand in a list of literals.
enum class ListKind { kConditions, kChanges };

/// Reads the literals of a rule's text.
class LiteralParser {
 public:
  explicit LiteralParser(std::shared_ptr<const SymbolTable> symbols)
      : symbols_(std::move(symbols)) {}

  /// "on(X, Y), not clear(Y), size(X) >= 3"
  /// @param scope  the rule whose variables may be named
  /// @throws RuleError
  std::vector<Literal> ReadList(ListKind kind, const Rule& scope,
                                TokenReader& in) const;
  Literal Read(ListKind kind, const Rule& scope, TokenReader& in) const;

 private:
  Literal ReadSame(ListKind kind, bool is_negated, const Rule& scope,
                   TokenReader& in) const;
  void ReadComparison(bool is_negated, Literal* literal, TokenReader& in) const;
  void Check(const Literal& literal, ListKind kind,
             const TokenReader& in) const;
  Term ReadTerm(const Rule& scope, TokenReader& in) const;
  const SymbolTable& symbols() const { return *symbols_; }

  std::shared_ptr<const SymbolTable> symbols_;
};

}  // namespace cell::rules
