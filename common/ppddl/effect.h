#pragma once

#include <vector>

#include "common/ppddl/condition.h"

namespace cell::ppddl {

/// A number, or the constant value of a function.
struct Amount {
  bool is_number = true;
  double number = 0;
  int function = 0;
  std::vector<Term> terms;
  bool operator==(const Amount&) const = default;
};

/// What an action changes (Younes and Littman, PPDDL 1.0, 2004).
struct Effect {
  enum class Kind {
    kAdd,            ///< the atom becomes true
    kDelete,         ///< the atom becomes false
    kAnd,            ///< all parts
    kWhen,           ///< the one part, if `condition` held before
    kForall,         ///< the one part, for all objects of `variables`
    kProbabilistic,  ///< one part by its probability, or nothing
    kIncrease,       ///< function (symbol, terms) by `amount`
    kDecrease
  };
  Kind kind = Kind::kAnd;
  int symbol = 0;  ///< predicate or function
  std::vector<Term> terms;
  std::vector<Variable> variables;
  Condition condition;
  Amount amount;
  std::vector<double> probabilities;  ///< of the parts; their sum is at most 1
  std::vector<Effect> parts;
  bool operator==(const Effect&) const = default;
};

}  // namespace cell::ppddl
