#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/ppddl/domain.h"
#include "common/ppddl/expression.h"

namespace cell::rexd {

/// Fails where a list within `in` begins with the word, or at `in`.
/// @throws ppddl::PpddlError
[[noreturn]] void FailAt(const ppddl::Expression& in, const std::string& word,
                         const std::string& message);

/// An action of PPDDL as a noisy deictic rule, see RulesOfPpddl().
class PpddlRule {
 public:
  /// @param where  the action in the text, for errors
  /// @throws ppddl::PpddlError for what rules have no words for
  PpddlRule(const ppddl::Domain& domain, const ppddl::Action& action,
            const ppddl::Expression& where);

  /// The action's declaration: "stack 2 action <-- block(X) block(Y)".
  std::string Declaration() const;
  /// The rule as rules::ParseRules() reads it.
  std::string Text() const;

 private:
  struct Outcome {
    double probability = 1;
    std::vector<std::string> added;
    std::vector<std::string> deleted;
  };

  /// The expression after ":precondition" or ":effect".
  const ppddl::Expression& PartOf(const std::string& key) const;
  std::string TypeName(int type) const;
  std::string NameOf(int parameter) const;
  std::vector<std::string> ArgumentNames() const;
  /// @param other  text of the variables after the parameters
  std::string TermText(const ppddl::Term& term, const std::string& other) const;
  std::string AtomText(const ppddl::Condition& atom,
                       const std::string& other) const;

  /// "(forall (?o) (imply (and (on ?x ?o) ...) (= ?o ?y)))": ?y is a reference.
  bool IsReference(const ppddl::Condition& condition, int* parameter,
                   std::vector<std::string>* literals) const;
  void FindReferences(const ppddl::Condition& condition);
  void AddCondition(const ppddl::Condition& condition, bool is_negated);
  /// Some object, or none, for which an atom holds: `_`.
  void AddQuantified(const ppddl::Condition& condition, bool is_negated);
  /// True if each variable is once in the atom and as wide as its place.
  bool AreOnce(const ppddl::Condition& atom,
               const std::vector<ppddl::Variable>& variables) const;

  std::vector<Outcome> OutcomesOf(const ppddl::Effect& effect) const;
  std::vector<Outcome> Jointly(const ppddl::Effect& effect) const;
  std::vector<Outcome> ByChance(const ppddl::Effect& effect) const;
  /// Of contradicting effects an addition counts, so additions come last.
  static std::string Changes(const Outcome& outcome);

  const ppddl::Domain& domain_;
  const ppddl::Action& action_;
  const ppddl::Expression& where_;
  std::vector<std::string> context_;
  std::map<int, std::vector<std::string>> references_;  // by parameter
};

}  // namespace cell::rexd
