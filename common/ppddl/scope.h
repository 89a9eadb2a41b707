#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/ppddl/domain.h"
#include "common/ppddl/expression.h"

namespace cell::ppddl {

/// The names that a formula may use, and how they are looked up. All functions
/// throw PpddlError where a name is unknown or an argument does not fit.
class Scope {
 public:
  /// Of a domain: its constants are the objects.
  explicit Scope(const Domain& domain);

  /// Adds a problem's objects.
  void AddObject(const Object& object, const Expression& where);
  /// Variables of a quantifier, until RemoveVariables().
  void AddVariables(const std::vector<Variable>& variables);
  void RemoveVariables(size_t number);

  const Domain& domain() const { return domain_; }
  const std::vector<Object>& objects() const { return objects_; }

  int TypeOf(const Expression& name) const;
  int PredicateOf(const Expression& name) const;
  int FunctionOf(const Expression& name) const;
  /// An object, or a variable if there are any in the scope.
  Term TermOf(const Expression& name) const;
  /// The items of `list` after the first as arguments of `symbol`.
  std::vector<Term> ArgumentsOf(const Expression& list,
                                const Symbol& symbol) const;

 private:
  int TypeOfTerm(const Term& term) const;

  const Domain& domain_;
  std::vector<Object> objects_;
  std::vector<Variable> variables_;
  std::map<std::string, int> types_;
  std::map<std::string, int> predicates_;
  std::map<std::string, int> functions_;
  std::map<std::string, int> object_of_;
};

/// A name and the type that a list gives to it.
struct TypedName {
  const Expression* name;
  int type;
};

/// "a b - block c" from `first` on; without a type: object.
std::vector<TypedName> ReadTypedNames(const Expression& list, size_t first,
                                      const Scope& scope);
/// Variables "(?x ?y - block)"; each name once, none that the scope knows.
std::vector<Variable> ReadVariables(const Expression& list, size_t first,
                                    const Scope& scope);

/// @throws PpddlError unless it is a list that begins with `word`, with so
/// many items after it (-1: any number); `form` shows what would be right.
void Expect(const Expression& list, const std::string& word, int num_items,
            const std::string& form);
/// A name: no list, no variable, no number, no keyword.
const std::string& ReadName(const Expression& name, const std::string& what);
/// Of rewards and function values.
inline constexpr double kMaxNumber = 1e15;
/// "0.25" or "1/4". @throws PpddlError unless it is finite and in [low, high]
double ReadNumber(const Expression& word, double low, double high);

}  // namespace cell::ppddl
