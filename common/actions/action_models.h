#pragma once

#include <vector>

#include "common/actions/action_model.h"
#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "common/result/result.h"

namespace cell {

/// The action models that a service works with: those of the task at first;
/// then the library's records replace them, action by action. A value: users of
/// a model must fetch it again when it changes.
class ActionModels {
 public:
  enum class Update { kNone, kChanged };

  /// @pre `models` are those of the domain's actions, in their order.
  ActionModels(Domain domain, PartTable parts, std::vector<ActionModel> models);

  const Domain& domain() const { return domain_; }
  const PartTable& parts() const { return parts_; }
  /// In the domain's order.
  const std::vector<ActionModel>& models() const { return models_; }

  /// Replaces the model of this name. An equal record changes nothing. Refuses
  /// a record that the domain cannot express, with ReadActionModel()'s reason.
  Result<Update> Apply(const ActionRecord& record);

 private:
  Domain domain_;
  PartTable parts_;
  std::vector<ActionModel> models_;
};

}  // namespace cell
