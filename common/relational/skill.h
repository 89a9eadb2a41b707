#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/relational/literal.h"

namespace cell {

/// How an arm does an action: the bridge between a symbol and a motion
/// (section VIII-A). In domain.yaml
///
///   skill: {kind: insert, part: X, site: frame.hole, arm: right}
///
/// where each term is a variable of the action or an object. `site` is of
/// insert alone: take the part and seat it there. present: set it down where
/// the other arm can take it. put_down: on a free place.
struct Skill {
  enum class Kind { kInsert, kPresent, kPutDown };
  Kind kind = Kind::kInsert;
  Term part;
  Term site;  ///< of kInsert
  Term arm;
  bool operator==(const Skill&) const = default;

  /// @throws ConfigError for unknown kinds, variables and objects, and for a
  /// site that is missing or too much.
  static Skill FromConfig(const Config& config, const Vocabulary& vocabulary,
                          std::span<const Variable> arguments);
};

/// "put_down", as in domain.yaml.
const char* NameOf(Skill::Kind kind);

/// A skill with its objects.
struct GroundSkill {
  Skill::Kind kind = Skill::Kind::kInsert;
  int part = 0;
  std::optional<int> site;
  int arm = 0;
  bool operator==(const GroundSkill&) const = default;
};

GroundSkill Bind(const Skill& skill, const Binding& arguments);

}  // namespace cell
