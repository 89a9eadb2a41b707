#include "common/sec/learned_library.h"

#include <algorithm>
#include <utility>

#include "common/scene/scene_objects.h"
#include "common/sec/bound_scene.h"
#include "common/sec/learned_model_text.h"
#include "common/sec/stand_ins.h"

namespace cell {
namespace {

constexpr double kLiteralWeight = 2;
constexpr double kRelationWeight = 1;
constexpr double kOpenShare = 0.5;  // of a literal that the scene leaves open

class Model final : public SecModel {
 public:
  Model(LearnedLibrary::Entry entry, std::set<int> stand_ins,
        std::shared_ptr<const SceneWords> words)
      : action_(std::move(entry.action)),
        model_(std::move(entry.model)),
        stand_ins_(std::move(stand_ins)),
        words_(std::move(words)),
        required_(model_.RequiredLiterals()),
        changed_(ChangedLiterals(model_.pick, model_.place)),
        partners_(ChangedPartners(model_.pick, model_.place)),
        certain_partners_(partners_) {
    std::erase_if(certain_partners_, [](const Partner& partner) {
      return partner.kind == Partner::Kind::kType;
    });
  }

  const std::string& action() const override { return action_; }

  /// As far as types, static relations and what must change allow them.
  std::vector<Roles> RolesAtPickUp(const std::string& part,
                                   const SensedFrame& before,
                                   ActionDirection direction) const override {
    std::vector<Roles> found;
    for (const Binding& binding : BindingsFor(part)) {
      const BoundScene scene(*words_, binding, model_.moved, before);
      if (std::ranges::all_of(required_, [&](const Literal& literal) {
            return scene.MayHold(AtBegin(literal, direction));
          })) {
        found.push_back(RolesOf(binding));
      }
    }
    return found;
  }

  bool HasStandIn(const Roles& roles) const override {
    return stand_ins_.contains(BindingOf(roles)[model_.moved]);
  }

  double Agreement(const ObservedManipulation& manipulation, const Roles& roles,
                   ActionDirection direction) const override {
    const Binding binding = BindingOf(roles);
    const bool is_forward = direction == ActionDirection::kForward;
    const BoundScene before(*words_, binding, model_.moved,
                            manipulation.before);
    const BoundScene after(*words_, binding, model_.moved, manipulation.after);
    if (!HasRequired(manipulation, before, after, direction)) return 0;
    double held = 0, all = 2 * Unexplained(manipulation, binding);
    const auto put = [&](double weight, double share, bool, const auto&) {
      held += weight * share;
      all += weight;
    };
    ForEachFact(is_forward ? model_.pick : model_.place, before, binding, put);
    ForEachFact(is_forward ? model_.place : model_.pick, after, binding, put);
    return held / all;
  }

  std::vector<CheckedFact> Check(const ObservedManipulation& manipulation,
                                 const Roles& roles,
                                 ActionDirection direction) const override {
    const Binding binding = BindingOf(roles);
    std::vector<CheckedFact> checked;
    for (const bool is_before : {true, false}) {
      const BoundScene scene(
          *words_, binding, model_.moved,
          is_before ? manipulation.before : manipulation.after);
      const bool is_pick =
          is_before == (direction == ActionDirection::kForward);
      ForEachFact(
          is_pick ? model_.pick : model_.place, scene, binding,
          [&](double weight, double share, bool is_required, const auto& text) {
            checked.push_back({is_before ? CheckedFact::When::kBefore
                                         : CheckedFact::When::kAfter,
                               text(), weight, share, is_required});
          });
    }
    AddUnexplained(manipulation, binding, &checked);
    return checked;
  }

 private:
  void AddUnexplained(const ObservedManipulation& manipulation,
                      const Binding& binding,
                      std::vector<CheckedFact>* checked) const {
    const auto add = [&](std::string text, double weight) {
      checked->push_back({CheckedFact::When::kUnexplained, std::move(text),
                          2 * weight, 0, false});
    };
    for (const int atom : UnexplainedAtoms(manipulation, binding)) {
      const bool is_true = manipulation.after.state.Get(atom) == Truth::kTrue;
      add((is_true ? "" : "not ") + words_->vocabulary.AtomName(atom),
          kLiteralWeight);
    }
    for (const std::string& name : UnexplainedPartners(manipulation, binding)) {
      const bool touches =
          Touch(manipulation.after.frame.relations, manipulation.part, name);
      add((touches ? "touches " : "apart from ") + name, kRelationWeight);
    }
  }

  /// The literal of `pick` as it is when the action begins.
  static Literal AtBegin(const Literal& literal, ActionDirection direction) {
    return direction == ActionDirection::kForward ? literal : Negated(literal);
  }

  bool HasRequired(const ObservedManipulation& manipulation,
                   const BoundScene& before, const BoundScene& after,
                   ActionDirection direction) const {
    if (required_.empty()) {
      return HaveChanged(partners_, before, after, direction);
    }
    bool is_certain = true;
    for (const Literal& literal : required_) {
      const Literal begin = AtBegin(literal, direction);
      if (!before.MayHold(begin) || !after.MayHold(Negated(begin))) {
        return false;
      }
      is_certain = is_certain && after.MustHold(Negated(begin));
    }
    return is_certain ||
           (IsSeen(manipulation) && !certain_partners_.empty() &&
            HaveChanged(certain_partners_, before, after, direction) &&
            HasArrived(after, direction));
  }

  /// It has a pose before and after.
  static bool IsSeen(const ObservedManipulation& manipulation) {
    return manipulation.before.frame.poses.contains(manipulation.part) &&
           manipulation.after.frame.poses.contains(manipulation.part);
  }

  bool HasArrived(const BoundScene& after, ActionDirection direction) const {
    const SceneFacts& facts =
        direction == ActionDirection::kForward ? model_.place : model_.pick;
    return std::ranges::any_of(facts.touch, [&](const Partner& partner) {
      return after.Touches(partner);
    });
  }

  bool HaveChanged(const std::set<Partner>& partners, const BoundScene& before,
                   const BoundScene& after, ActionDirection direction) const {
    return std::ranges::all_of(partners, [&](const Partner& partner) {
      const bool touches_first = model_.pick.touch.contains(partner) ==
                                 (direction == ActionDirection::kForward);
      return before.Touches(partner) == touches_first &&
             after.Touches(partner) != touches_first;
    });
  }

  /// Calls put(weight, share that holds, text()) for each fact.
  template <class Put>
  void ForEachFact(const SceneFacts& facts, const BoundScene& scene,
                   const Binding& binding, Put put) const {
    for (const Literal& literal : facts.where) {
      if (literal.is_static) continue;
      const double share = scene.MustHold(literal)  ? 1
                           : scene.MayHold(literal) ? kOpenShare
                                                    : 0;
      put(kLiteralWeight, share, IsRequired(literal),
          [&] { return Show(literal, binding, words_->vocabulary); });
    }
    for (const bool touches : {true, false}) {
      for (const Partner& partner : touches ? facts.touch : facts.apart) {
        put(kRelationWeight, scene.Touches(partner) == touches ? 1 : 0, false,
            [&] { return ToText(partner, touches, VariablesOf(binding)); });
      }
    }
  }

  bool IsRequired(const Literal& literal) const {
    return required_.contains(literal) || required_.contains(Negated(literal));
  }

  /// The objects, in place of the roles.
  std::vector<Variable> VariablesOf(const Binding& binding) const {
    std::vector<Variable> objects;
    for (size_t i = 0; i < binding.size(); ++i) {
      objects.push_back({ObjectName(binding[i]), model_.roles[i].type});
    }
    return objects;
  }

  /// The weight of the moved part's changes that the model does not mention.
  double Unexplained(const ObservedManipulation& manipulation,
                     const Binding& binding) const {
    return kLiteralWeight *
               static_cast<double>(
                   UnexplainedAtoms(manipulation, binding).size()) +
           kRelationWeight *
               static_cast<double>(
                   UnexplainedPartners(manipulation, binding).size());
  }

  std::vector<int> UnexplainedAtoms(const ObservedManipulation& manipulation,
                                    const Binding& binding) const {
    const Vocabulary& vocabulary = words_->vocabulary;
    std::set<int> explained;
    for (const Literal& literal : changed_) {
      const auto atoms = Groundings(literal, binding, vocabulary);
      explained.insert(atoms.begin(), atoms.end());
    }
    std::vector<int> changes;
    for (int i = 0; i < vocabulary.num_atoms(); ++i) {
      const Truth before = manipulation.before.state.Get(i);
      const Truth after = manipulation.after.state.Get(i);
      if (before == after || before == Truth::kUnknown ||
          after == Truth::kUnknown || explained.contains(i)) {
        continue;
      }
      const GroundAtom atom = vocabulary.Atom(i);
      if (std::ranges::count(atom.objects, binding[model_.moved]) > 0) {
        changes.push_back(i);
      }
    }
    return changes;
  }

  std::vector<std::string> UnexplainedPartners(
      const ObservedManipulation& manipulation, const Binding& binding) const {
    std::set<std::string> explained = {manipulation.part};
    for (const Partner& partner : partners_) {
      explained.insert(partner.kind == Partner::Kind::kRole
                           ? words_->PartOf(binding[partner.role])
                           : partner.name);
    }
    std::vector<std::string> changes;
    const auto check = [&](const std::string& name) {
      if (!explained.contains(name) &&
          Touch(manipulation.before.frame.relations, manipulation.part, name) !=
              Touch(manipulation.after.frame.relations, manipulation.part,
                    name)) {
        changes.push_back(name);
      }
    };
    check(SceneObjects::kTable);
    for (const Part& part : words_->parts.parts()) {
      if (part.is_fixed) check(part.name);
    }
    return changes;
  }

  std::vector<Binding> BindingsFor(const std::string& part) const {
    const Vocabulary& vocabulary = words_->vocabulary;
    const auto moved = vocabulary.FindObject(part);
    std::vector<Binding> bindings = {{}};
    for (size_t i = 0; i < model_.roles.size(); ++i) {
      std::vector<Binding> longer;
      for (const int object : ObjectsFor(i)) {
        if ((i == model_.moved) != (object == moved)) continue;
        for (Binding binding : bindings) {
          if (std::ranges::count(binding, object) > 0) continue;
          binding.push_back(object);
          longer.push_back(std::move(binding));
        }
      }
      bindings = std::move(longer);
    }
    std::erase_if(bindings, [&](const Binding& binding) {
      return !StaticsHold(binding);
    });
    return bindings;
  }

  std::vector<int> ObjectsFor(size_t role) const {
    std::vector<int> objects =
        words_->vocabulary.ObjectsOf(model_.roles[role].type);
    if (role == model_.moved) {
      objects.insert(objects.end(), stand_ins_.begin(), stand_ins_.end());
    }
    return objects;
  }

  bool StaticsHold(const Binding& binding) const {
    const State nothing(words_->vocabulary.num_atoms());
    return std::ranges::all_of(model_.pick.where, [&](const Literal& literal) {
      return !literal.is_static ||
             MustHold(literal, binding, nothing, words_->vocabulary);
    });
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

  std::string action_;
  LearnedModel model_;
  std::set<int> stand_ins_;  // for the moved part
  std::shared_ptr<const SceneWords> words_;
  LiteralSet required_;         // as they are in pick
  LiteralSet changed_;          // of all roles, as they are in pick
  std::set<Partner> partners_;  // that are touched in pick or place only
  std::set<Partner> certain_partners_;  // those of them that are no types
};

}  // namespace

LearnedLibrary::LearnedLibrary(std::vector<Entry> entries,
                               std::shared_ptr<const SceneWords> words) {
  std::vector<LearnedModel> all;
  for (const Entry& entry : entries) all.push_back(entry.model);
  for (size_t i = 0; i < entries.size(); ++i) {
    models_.push_back(std::make_shared<const Model>(
        std::move(entries[i]), StandIns(all[i], all, words->vocabulary),
        words));
  }
}

}  // namespace cell
