#pragma once

#include <string>
#include <vector>

#include "common/actions/action_model.h"
#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"

namespace cell {

/// The action models that a service works with: those of the task at first;
/// then what the library says of an action replaces what was known of it. A
/// value; what others hold of it they must take anew when it changes.
class ActionModels {
 public:
  struct Update {
    bool has_changed = false;
    std::string refusal;  ///< why it was not taken; empty: it was
  };

  /// @pre `models` are those of the domain's actions, in their order.
  ActionModels(Domain domain, PartTable parts, std::vector<ActionModel> models);

  const Domain& domain() const { return domain_; }
  const PartTable& parts() const { return parts_; }
  /// In the domain's order.
  const std::vector<ActionModel>& models() const { return models_; }

  /// A record whose model is known as it is changes nothing. Refused is one
  /// that makes no sense in the domain, in the words of ReadActionModel().
  Update Take(const ActionRecord& record);

 private:
  Domain domain_;
  PartTable parts_;
  std::vector<ActionModel> models_;
};

}  // namespace cell
