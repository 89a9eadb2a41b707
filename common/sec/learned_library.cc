#include "common/sec/learned_library.h"

#include <algorithm>
#include <utility>

#include "common/scene/scene_objects.h"
#include "common/sec/bound_scene.h"
#include "common/sec/stand_ins.h"

namespace cell {
namespace {

constexpr double kLiteralWeight = 2;
constexpr double kRelationWeight = 1;

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
        partners_(ChangedPartners(model_.pick, model_.place)) {}

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
    if (!HasRequired(before, after, direction)) return 0;
    Tally tally;
    Count(is_forward ? model_.pick : model_.place, before, &tally);
    Count(is_forward ? model_.place : model_.pick, after, &tally);
    tally.all += 2 * Unexplained(manipulation, binding);
    return tally.held / tally.all;
  }

 private:
  struct Tally {
    double held = 0;
    double all = 0;

    void Put(double weight, bool holds) {
      all += weight;
      if (holds) held += weight;
    }
  };

  /// The literal of `pick` as it is when the action begins.
  static Literal AtBegin(const Literal& literal, ActionDirection direction) {
    return direction == ActionDirection::kForward ? literal : Negated(literal);
  }

  bool HasRequired(const BoundScene& before, const BoundScene& after,
                   ActionDirection direction) const {
    if (required_.empty()) return HavePartnersChanged(before, after, direction);
    return std::ranges::all_of(required_, [&](const Literal& literal) {
      const Literal begin = AtBegin(literal, direction);
      return before.MayHold(begin) && after.MustHold(Negated(begin));
    });
  }

  bool HavePartnersChanged(const BoundScene& before, const BoundScene& after,
                           ActionDirection direction) const {
    return std::ranges::all_of(partners_, [&](const Partner& partner) {
      const bool touches_first = model_.pick.touch.contains(partner) ==
                                 (direction == ActionDirection::kForward);
      return before.Touches(partner) == touches_first &&
             after.Touches(partner) != touches_first;
    });
  }

  static void Count(const SceneFacts& facts, const BoundScene& scene,
                    Tally* tally) {
    for (const Literal& literal : facts.where) {
      if (!literal.is_static) {
        tally->Put(kLiteralWeight, scene.MustHold(literal));
      }
    }
    for (const Partner& partner : facts.touch) {
      tally->Put(kRelationWeight, scene.Touches(partner));
    }
    for (const Partner& partner : facts.apart) {
      tally->Put(kRelationWeight, !scene.Touches(partner));
    }
  }

  /// The weight of the moved part's changes that the model does not mention.
  double Unexplained(const ObservedManipulation& manipulation,
                     const Binding& binding) const {
    return kLiteralWeight *
               static_cast<double>(UnexplainedAtoms(manipulation, binding)) +
           kRelationWeight *
               static_cast<double>(UnexplainedPartners(manipulation, binding));
  }

  std::ptrdiff_t UnexplainedAtoms(const ObservedManipulation& manipulation,
                                  const Binding& binding) const {
    const Vocabulary& vocabulary = words_->vocabulary;
    std::set<int> explained;
    for (const Literal& literal : changed_) {
      const auto atoms = Groundings(literal, binding, vocabulary);
      explained.insert(atoms.begin(), atoms.end());
    }
    std::ptrdiff_t count = 0;
    for (int i = 0; i < vocabulary.num_atoms(); ++i) {
      const Truth before = manipulation.before.state.Get(i);
      const Truth after = manipulation.after.state.Get(i);
      if (before == after || before == Truth::kUnknown ||
          after == Truth::kUnknown || explained.contains(i)) {
        continue;
      }
      const GroundAtom atom = vocabulary.Atom(i);
      count += std::ranges::count(atom.objects, binding[model_.moved]) > 0;
    }
    return count;
  }

  std::ptrdiff_t UnexplainedPartners(const ObservedManipulation& manipulation,
                                     const Binding& binding) const {
    std::set<std::string> explained = {manipulation.part};
    for (const Partner& partner : partners_) {
      explained.insert(partner.kind == Partner::Kind::kRole
                           ? words_->PartOf(binding[partner.role])
                           : partner.name);
    }
    const auto has_changed = [&](const std::string& name) {
      return !explained.contains(name) &&
             Touch(manipulation.before.frame.relations, manipulation.part,
                   name) != Touch(manipulation.after.frame.relations,
                                  manipulation.part, name);
    };
    return has_changed(SceneObjects::kTable) +
           std::ranges::count_if(words_->parts.parts(), [&](const Part& part) {
             return part.is_fixed && has_changed(part.name);
           });
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
