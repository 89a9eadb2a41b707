#include "common/task/reference_rules.h"

#include "common/task/task_actions.h"

namespace cell {

Domain WithReferenceRules(Domain domain, const Config& file) {
  for (const auto& [name, node] : file["actions"].Entries()) {
    const auto known = domain.FindAction(name);
    if (!known) node.Fail("domain.yaml has no action '" + name + "'");
    Action action = domain.actions()[static_cast<size_t>(*known)];
    const Action reference = LoadAction(name, node, domain.vocabulary());
    if (!action.TakesArgumentsOf(reference)) {
      node["arguments"].Fail("are others in domain.yaml");
    }
    action.rules = reference.rules;
    for (NdrRule& rule : action.rules) rule.agents = action.agents;
    domain.Put(action);
  }
  file.Finish();
  CompleteActions({}, &domain);
  return domain;
}

}  // namespace cell
