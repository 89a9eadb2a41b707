#pragma once

#include <array>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "common/parts/part_table.h"
#include "common/relational/literal.h"

namespace cell {

/// What is said of a scene; what it does not mention does not matter.
struct SceneCondition {
  /// Place of an argument in the action, or the name of an object.
  using Role = std::variant<size_t, std::string>;
  using Pair = std::array<Role, 2>;

  std::vector<Pair> touch;     ///< pairs that touch
  std::vector<Pair> apart;     ///< pairs that do not
  std::vector<Literal> where;  ///< what is true

  bool operator==(const SceneCondition&) const = default;
};

/// The characteristic pair of key frames of an action (section VII-A), as
/// conditions that were written by hand.
struct SecConditions {
  size_t moved = 0;      ///< which argument is picked up and placed
  SceneCondition pick;   ///< before the hand comes
  SceneCondition place;  ///< after the hand has left

  bool operator==(const SecConditions&) const = default;

  /// Reads
  ///
  ///   moved: X
  ///   pick:  {where: [not Inside(X, Y)], touch: [[X, table]]}
  ///   place: {where: ["Inside(X, Y)"], apart: [[X, table]]}
  ///
  /// In touch and apart a site stands for the part that has it.
  /// @throws ConfigError naming file:key; also if pick or place say nothing of
  /// what is moved, or neither of them of another argument.
  static SecConditions FromConfig(const Config& config,
                                  std::span<const Variable> arguments,
                                  const Vocabulary& vocabulary,
                                  const PartTable& parts);
};

}  // namespace cell
