#pragma once

#include <memory>
#include <vector>

#include "common/actions/action_model.h"
#include "common/config/deployment.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/predicates/predicate_sensor.h"
#include "common/relational/domain.h"
#include "common/scene/scene_objects.h"

namespace cell {

/// The task that a cell works on: its parts.yaml, cell.yaml, domain.yaml with
/// the learned rules that it names, and sec_models.yaml, each read once,
/// strictly, and held against the others. What only one service reads
/// (skills.yaml, demonstrators.yaml) it reads itself.
struct Task {
  PartTable parts;
  CellLayout layout;
  SceneObjects scene_objects;
  Domain domain;                              ///< with the actions of `actions`
  std::vector<PredicateGeometry> geometries;  ///< of the domain's predicates
  std::vector<ActionModel> actions;           ///< in the domain's order

  /// What senses the domain's predicates.
  std::shared_ptr<const PredicateSensor> MakeSensor(
      const PoseUncertainty& uncertainty = {}) const;
};

/// Whether actions get the rules that were learned of them.
enum class LearnedRules { kRead, kLeaveOut };

/// @throws ConfigError naming file:key, or file:line of learned rules.
Task LoadTask(const Deployment& deployment,
              LearnedRules learned_rules = LearnedRules::kRead);

}  // namespace cell
