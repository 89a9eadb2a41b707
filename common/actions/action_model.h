#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/relational/rule.h"
#include "common/sec/learned_model.h"

namespace cell {

/// What the cell knows of an action, and what ties the paper's three levels
/// together: a symbol with typed arguments, how it is recognised, what it
/// does, and how an arm does it. A value in the words of a domain.
struct ActionModel {
  int64_t version = 1;              ///< counts the models of this name
  Action action;                    ///< symbol, rule set, skill
  std::optional<LearnedModel> sec;  ///< how it is recognised; nothing: never
  /// Section of the task's skills.yaml; empty: no arm can do it.
  std::string skill_settings;

  bool operator==(const ActionModel&) const = default;
};

/// The section of skills.yaml that has the figures of a skill.
std::string SettingsOf(const SkillBinding& skill);

}  // namespace cell
