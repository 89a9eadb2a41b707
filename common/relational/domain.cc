#include "common/relational/domain.h"

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

void AddGroundActions(const Domain& domain, int action, Agent agent,
                      Binding& arguments, std::vector<GroundAction>& found) {
  const Action& lifted = domain.actions()[action];
  const Vocabulary& vocabulary = domain.vocabulary();
  if (arguments.size() == lifted.arguments.size()) {
    if (IsPossible(lifted, arguments, vocabulary, agent)) {
      found.push_back({action, arguments});
    }
    return;
  }
  const int type = lifted.arguments[arguments.size()].type;
  for (const int object : vocabulary.ObjectsOf(type)) {
    arguments.push_back(object);
    AddGroundActions(domain, action, agent, arguments, found);
    arguments.pop_back();
  }
}

}  // namespace

bool Domain::Put(const Action& action) {
  const std::optional<int> known = FindAction(action.name);
  if (!known) {
    actions_.push_back(action);
    return true;
  }
  Action& kept = actions_[static_cast<size_t>(*known)];
  if (kept == action) return false;
  kept = action;
  return true;
}

std::optional<int> Domain::FindAction(const std::string& name) const {
  for (size_t i = 0; i < actions_.size(); ++i) {
    if (actions_[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

const Goal* Domain::FindGoal(const std::string& name) const {
  const auto it = std::find_if(goals_.begin(), goals_.end(),
                               [&](const Goal& g) { return g.name == name; });
  return it == goals_.end() ? nullptr : &*it;
}

std::vector<GroundAction> Domain::GroundActions(Agent agent) const {
  std::vector<GroundAction> found;
  for (size_t i = 0; i < actions_.size(); ++i) {
    Binding arguments;
    if (actions_[i].MayBeDoneBy(agent)) {
      AddGroundActions(*this, static_cast<int>(i), agent, arguments, found);
    }
  }
  return found;
}

std::optional<GroundAction> Domain::FindGroundAction(
    const std::string& name, const std::vector<std::string>& objects) const {
  const std::optional<int> action = FindAction(name);
  if (!action) return std::nullopt;
  const std::vector<Variable>& arguments = actions_[*action].arguments;
  if (objects.size() != arguments.size()) return std::nullopt;
  GroundAction ground{*action, {}};
  for (size_t i = 0; i < objects.size(); ++i) {
    const std::optional<int> object = vocabulary_.FindObject(objects[i]);
    if (!object || !vocabulary_.IsOf(*object, arguments[i].type)) {
      return std::nullopt;
    }
    ground.arguments.push_back(*object);
  }
  return ground;
}

std::optional<GroundSkill> Domain::SkillOf(const GroundAction& action) const {
  const std::optional<Skill>& skill = actions_.at(action.action).skill;
  if (!skill) return std::nullopt;
  return Bind(*skill, action.arguments);
}

std::string Domain::Show(const GroundAction& action) const {
  return vocabulary_.Show(actions_.at(action.action).name, action.arguments);
}

}  // namespace cell
