#include "common/sec/condition_library.h"

#include <algorithm>
#include <utility>

namespace cell {
namespace {

/// What the models of a library share.
struct Words {
  Vocabulary vocabulary;
  PartTable parts;
};

class ConditionModel final : public SecModel {
 public:
  ConditionModel(ConditionLibrary::Entry entry,
                 std::shared_ptr<const Words> words)
      : entry_(std::move(entry)), words_(std::move(words)) {}

  const std::string& action() const override { return entry_.action; }

  /// As far as types, static relations and `before` allow them.
  std::vector<Roles> RolesAtPickUp(const std::string& part,
                                   const SensedFrame& before,
                                   ActionDirection direction) const override {
    std::vector<Roles> found;
    for (const Binding& binding : BindingsFor(part)) {
      if (MayHoldIn(Begin(direction), binding, before)) {
        found.push_back(RolesOf(binding));
      }
    }
    return found;
  }

  double Agreement(const ObservedManipulation& manipulation, const Roles& roles,
                   ActionDirection direction) const override {
    return MustHoldIn(End(direction), BindingOf(roles), manipulation.after);
  }

 private:
  const SceneCondition& Begin(ActionDirection direction) const {
    return direction == ActionDirection::kForward ? entry_.conditions.pick
                                                  : entry_.conditions.place;
  }
  const SceneCondition& End(ActionDirection direction) const {
    return direction == ActionDirection::kForward ? entry_.conditions.place
                                                  : entry_.conditions.pick;
  }

  std::vector<Binding> BindingsFor(const std::string& part) const {
    const auto moved = words_->vocabulary.FindObject(part);
    std::vector<Binding> bindings = {{}};
    for (size_t i = 0; i < entry_.arguments.size(); ++i) {
      std::vector<Binding> longer;
      for (const int object :
           words_->vocabulary.ObjectsOf(entry_.arguments[i].type)) {
        if (i == entry_.conditions.moved && object != moved) continue;
        for (Binding binding : bindings) {
          binding.push_back(object);
          longer.push_back(std::move(binding));
        }
      }
      bindings = std::move(longer);
    }
    std::erase_if(bindings, [&](const Binding& binding) {
      return !StaticsHold(entry_.conditions.pick, binding) ||
             !StaticsHold(entry_.conditions.place, binding);
    });
    return bindings;
  }

  /// False if the frame contradicts the condition.
  bool MayHoldIn(const SceneCondition& condition, const Binding& binding,
                 const SensedFrame& frame) const {
    return TouchesHold(condition, binding, frame.frame.relations) &&
           MayHold(condition.where, binding, frame.state, words_->vocabulary);
  }

  /// True if the frame leaves no doubt of it.
  bool MustHoldIn(const SceneCondition& condition, const Binding& binding,
                  const SensedFrame& frame) const {
    return TouchesHold(condition, binding, frame.frame.relations) &&
           std::all_of(condition.where.begin(), condition.where.end(),
                       [&](const Literal& literal) {
                         return MustHold(literal, binding, frame.state,
                                         words_->vocabulary);
                       });
  }

  bool TouchesHold(const SceneCondition& condition, const Binding& binding,
                   const TouchGraph& graph) const {
    const auto touch = [&](const SceneCondition::Pair& pair) {
      return Touch(graph, NameOf(pair[0], binding), NameOf(pair[1], binding));
    };
    return std::all_of(condition.touch.begin(), condition.touch.end(), touch) &&
           std::none_of(condition.apart.begin(), condition.apart.end(), touch);
  }

  bool StaticsHold(const SceneCondition& condition,
                   const Binding& binding) const {
    const State nothing(words_->vocabulary.num_atoms());
    return std::all_of(condition.where.begin(), condition.where.end(),
                       [&](const Literal& literal) {
                         return !literal.is_static ||
                                MustHold(literal, binding, nothing,
                                         words_->vocabulary);
                       });
  }

  std::string NameOf(const SceneCondition::Role& role,
                     const Binding& binding) const {
    if (const auto* name = std::get_if<std::string>(&role)) return *name;
    const std::string& name = ObjectName(binding[std::get<size_t>(role)]);
    const Site* site = words_->parts.FindSite(name);
    return site ? site->host : name;
  }

  const std::string& ObjectName(int object) const {
    return words_->vocabulary.objects()[static_cast<size_t>(object)].name;
  }
  Roles RolesOf(const Binding& binding) const {
    Roles roles;
    for (const int object : binding) roles.push_back(ObjectName(object));
    return roles;
  }
  Binding BindingOf(const Roles& roles) const {
    Binding binding;
    for (const std::string& name : roles) {
      binding.push_back(words_->vocabulary.FindObject(name).value());
    }
    return binding;
  }

  ConditionLibrary::Entry entry_;
  std::shared_ptr<const Words> words_;
};

}  // namespace

ConditionLibrary::ConditionLibrary(std::vector<Entry> entries,
                                   const Vocabulary& vocabulary,
                                   const PartTable& parts) {
  const auto words = std::make_shared<const Words>(Words{vocabulary, parts});
  for (Entry& entry : entries) {
    models_.push_back(
        std::make_shared<const ConditionModel>(std::move(entry), words));
  }
}

}  // namespace cell
