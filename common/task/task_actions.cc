#include "common/task/task_actions.h"

#include <vector>

#include "common/actions/skill_needs.h"
#include "common/relational/undoing.h"

namespace cell {

void CompleteActions(Domain* domain) {
  const std::vector<Action> actions = domain->actions();
  for (Action action : actions) {
    if (!action.undoes) {
      action.undoes = DeriveUndone(action, actions, domain->goals());
    }
    domain->Put(WithSkillNeeds(action, domain->vocabulary()));
  }
}

}  // namespace cell
