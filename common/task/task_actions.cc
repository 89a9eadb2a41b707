#include "common/task/task_actions.h"

#include <optional>
#include <vector>

#include "common/actions/skill_needs.h"
#include "common/relational/undoing.h"

namespace cell {
namespace {

std::optional<int> UndoneByChains(const Action& action,
                                  const std::vector<Action>& actions,
                                  const std::set<std::string>& shown) {
  if (shown.contains(action.name) || !action.MayBeDoneBy(Agent::kPerson)) {
    return std::nullopt;
  }
  std::optional<int> undone;
  for (size_t i = 0; i < actions.size(); ++i) {
    if (!shown.contains(actions[i].name) ||
        !actions[i].TakesArgumentsOf(action)) {
      continue;
    }
    if (undone) return std::nullopt;
    undone = static_cast<int>(i);
  }
  return undone;
}

}  // namespace

void CompleteActions(const std::set<std::string>& shown, Domain* domain) {
  const std::vector<Action> actions = domain->actions();
  for (Action action : actions) {
    if (!action.undoes) {
      action.undoes = DeriveUndone(action, actions, domain->goals());
    }
    if (!action.undoes) action.undoes = UndoneByChains(action, actions, shown);
    domain->Put(WithSkillNeeds(action, domain->vocabulary()));
  }
}

}  // namespace cell
