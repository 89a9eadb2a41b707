#include "common/relational/ground_action.h"

#include <algorithm>

namespace cell {
namespace {

/// False if no rule can ever apply to the arguments.
bool IsPossible(const Action& action, const Binding& arguments,
                const Vocabulary& vocabulary, Agent agent) {
  const State nothing(vocabulary.num_atoms());
  const auto is_of_arguments = [&](const Literal& literal) {
    return std::all_of(literal.terms.begin(), literal.terms.end(),
                       [&](const Term& term) {
                         return term.kind != Term::Kind::kVariable ||
                                term.index < static_cast<int>(arguments.size());
                       });
  };
  return std::any_of(
      action.rules.begin(), action.rules.end(), [&](const NdrRule& rule) {
        return rule.IsFor(agent) &&
               std::all_of(rule.context.begin(), rule.context.end(),
                           [&](const Literal& l) {
                             return !l.is_static || !is_of_arguments(l) ||
                                    MayHold(l, arguments, nothing, vocabulary);
                           });
      });
}

/// Adds the groundings of actions[action] that begin with `arguments`.
void AddGroundActions(std::span<const Action> actions, int action,
                      const Vocabulary& vocabulary, Agent agent,
                      Binding& arguments, std::vector<GroundAction>& found) {
  const Action& lifted = actions[static_cast<size_t>(action)];
  if (arguments.size() == lifted.arguments.size()) {
    if (IsPossible(lifted, arguments, vocabulary, agent)) {
      found.push_back({action, arguments});
    }
    return;
  }
  const int type = lifted.arguments[arguments.size()].type;
  for (const int object : vocabulary.ObjectsOf(type)) {
    arguments.push_back(object);
    AddGroundActions(actions, action, vocabulary, agent, arguments, found);
    arguments.pop_back();
  }
}

}  // namespace

std::optional<int> FindAction(std::span<const Action> actions,
                              const std::string& name) {
  for (size_t i = 0; i < actions.size(); ++i) {
    if (actions[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::vector<GroundAction> GroundActions(std::span<const Action> actions,
                                        const Vocabulary& vocabulary,
                                        Agent agent) {
  std::vector<GroundAction> found;
  for (size_t i = 0; i < actions.size(); ++i) {
    Binding arguments;
    if (!actions[i].MayBeDoneBy(agent)) continue;
    AddGroundActions(actions, static_cast<int>(i), vocabulary, agent, arguments,
                     found);
  }
  return found;
}

std::optional<GroundAction> FindGroundAction(
    std::span<const Action> actions, const Vocabulary& vocabulary,
    const std::string& name, const std::vector<std::string>& objects) {
  const std::optional<int> action = FindAction(actions, name);
  if (!action) return std::nullopt;
  const auto& arguments = actions[static_cast<size_t>(*action)].arguments;
  if (objects.size() != arguments.size()) return std::nullopt;
  GroundAction ground{*action, {}};
  for (size_t i = 0; i < objects.size(); ++i) {
    const std::optional<int> object = vocabulary.FindObject(objects[i]);
    if (!object || !vocabulary.IsOf(*object, arguments[i].type)) {
      return std::nullopt;
    }
    ground.arguments.push_back(*object);
  }
  return ground;
}

}  // namespace cell
