#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/ppddl/domain.h"

namespace cell::ppddl {

struct GroundAtom {
  int predicate = 0;
  std::vector<int> objects;  ///< constants first, then the problem's objects
  auto operator<=>(const GroundAtom&) const = default;
};

/// "(= (distance a b) 5)"
struct FunctionValue {
  int function = 0;
  std::vector<int> objects;
  double value = 0;
  bool operator==(const FunctionValue&) const = default;
};

struct Metric {
  bool is_maximized = false;
  int function = 0;
  bool operator==(const Metric&) const = default;
};

/// A PPDDL problem of a domain. The metric and the rewards are kept but do not
/// guide the planner of common/planning.
struct Problem {
  std::string name;
  std::string domain_name;
  std::vector<std::string> requirements;
  std::vector<Object> objects;
  std::vector<GroundAtom> init;  ///< what is true at first, each atom once
  std::vector<FunctionValue> values;
  Condition goal;
  std::optional<double> goal_reward;
  std::optional<Metric> metric;
  bool operator==(const Problem&) const = default;
};

/// @throws PpddlError also if the problem is of another domain
Problem ParseProblem(std::string_view text, const std::string& file,
                     const Domain& domain);

/// The problem as PPDDL; ParseProblem() makes an equal one of it.
std::string ToText(const Problem& problem, const Domain& domain);

/// "on(a, b)"
std::string Show(const GroundAtom& atom, const Domain& domain,
                 const Problem& problem);

}  // namespace cell::ppddl
