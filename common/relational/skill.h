#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/relational/literal.h"

namespace cell {

/// How an arm does an action: the bridge between a symbol and a motion
/// (section VIII-A). In domain.yaml
///
///   skill: {name: insert, part: X, site: frame.hole, arm: right}
///
/// where each value but the name is a variable of the action or an object. The
/// name is that of a skill which the arm has; what is neither `name` nor `arm`
/// is an argument of it.
struct SkillBinding {
  std::string name;
  std::map<std::string, Term> arguments;
  Term arm;
  bool operator==(const SkillBinding&) const = default;

  /// @throws ConfigError for variables and objects that there are not.
  static SkillBinding FromConfig(const Config& config,
                                 const Vocabulary& vocabulary,
                                 std::span<const Variable> variables);
};

/// A skill with its objects.
struct GroundSkill {
  std::string name;
  std::map<std::string, int> arguments;
  int arm = 0;
  bool operator==(const GroundSkill&) const = default;
};

GroundSkill Bind(const SkillBinding& skill, const Binding& binding);

}  // namespace cell
