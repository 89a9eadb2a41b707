#include "common/sec/showing.h"

#include <algorithm>
#include <string>

#include "common/scene/scene_objects.h"
#include "common/sec/bound_scene.h"

namespace cell {
namespace {

bool Contains(std::span<const int> objects, int object) {
  return std::ranges::find(objects, object) != objects.end();
}

/// Calls visit(places) for every tuple of `size` of the first `count` numbers.
template <class Visit>
void ForEachTuple(size_t count, size_t size, Visit visit) {
  std::vector<size_t> places(size, 0);
  while (true) {
    visit(places);
    size_t i = 0;
    while (i < size && ++places[i] == count) places[i++] = 0;
    if (i == size) return;
  }
}

class Lifter {
 public:
  Lifter(const ObservedManipulation& manipulation, const SceneWords& words)
      : manipulation_(manipulation), words_(words) {}

  std::optional<Showing> Lift() const {
    const auto moved = words_.vocabulary.FindObject(manipulation_.part);
    if (!moved) return std::nullopt;
    Showing showing;
    showing.objects = RolesOf(*moved);
    if (showing.objects.size() > kMaxRoles) return std::nullopt;
    for (const int object : showing.objects) {
      showing.types.push_back(words_.vocabulary.objects()[object].type);
    }
    const std::set<Partner> partners = PartnersOf(showing.objects);
    showing.pick = FactsIn(manipulation_.before, showing.objects, partners);
    showing.place = FactsIn(manipulation_.after, showing.objects, partners);
    if (ChangedLiterals(showing.pick, showing.place).empty() &&
        ChangedPartners(showing.pick, showing.place).empty()) {
      return std::nullopt;
    }
    showing.pick.where.merge(Statics(showing.objects));
    showing.chain = ChainOf(showing.objects);
    return showing;
  }

 private:
  /// The moved part, and the objects of atoms of it that changed, in the order
  /// of the atoms.
  Binding RolesOf(int moved) const {
    Binding roles = {moved};
    for (int i = 0; i < words_.vocabulary.num_atoms(); ++i) {
      if (!HasChanged(i)) continue;
      const GroundAtom atom = words_.vocabulary.Atom(i);
      if (!Contains(atom.objects, moved)) continue;
      for (const int object : atom.objects) {
        if (!Contains(roles, object)) roles.push_back(object);
      }
    }
    return roles;
  }

  bool HasChanged(int atom) const {
    const Truth before = manipulation_.before.state.Get(atom);
    const Truth after = manipulation_.after.state.Get(atom);
    return before != Truth::kUnknown && after != Truth::kUnknown &&
           before != after;
  }

  /// Roles, the table and what is fixed are partners whether they are touched
  /// or not; others by their type if they are, before or after.
  std::set<Partner> PartnersOf(const Binding& roles) const {
    std::set<Partner> partners = {
        {Partner::Kind::kObject, 0, SceneObjects::kTable}};
    std::set<std::string> named = {manipulation_.part};
    for (size_t i = 1; i < roles.size(); ++i) {
      partners.insert({Partner::Kind::kRole, i, ""});
      named.insert(words_.PartOf(roles[i]));
    }
    for (const Part& part : words_.parts.parts()) {
      if (named.contains(part.name)) continue;
      if (part.is_fixed) {
        partners.insert({Partner::Kind::kObject, 0, part.name});
      } else if (IsTouched(part.name)) {
        partners.insert({Partner::Kind::kType, 0, part.type});
      }
    }
    return partners;
  }

  bool IsTouched(const std::string& part) const {
    return Touch(manipulation_.before.frame.relations, manipulation_.part,
                 part) ||
           Touch(manipulation_.after.frame.relations, manipulation_.part, part);
  }

  SceneFacts FactsIn(const SensedFrame& sensed, const Binding& roles,
                     const std::set<Partner>& partners) const {
    SceneFacts facts;
    const BoundScene scene(words_, roles, 0, sensed);
    for (const Partner& partner : partners) {
      (scene.Touches(partner) ? facts.touch : facts.apart).insert(partner);
    }
    const auto& predicates = words_.vocabulary.predicates();
    for (size_t i = 0; i < predicates.size(); ++i) {
      ForEachTuple(roles.size(), predicates[i].argument_types.size(),
                   [&](const std::vector<size_t>& places) {
                     Literal literal = LiteralOf(i, places);
                     const auto atom = words_.vocabulary.AtomIndex(
                         literal.relation, ObjectsAt(places, roles));
                     if (!atom) return;
                     const Truth truth = sensed.state.Get(*atom);
                     if (truth == Truth::kUnknown) return;
                     literal.is_negated = truth == Truth::kFalse;
                     facts.where.insert(std::move(literal));
                   });
    }
    return facts;
  }

  /// The static relations of the moved part and other roles.
  LiteralSet Statics(const Binding& roles) const {
    LiteralSet statics;
    const auto& relations = words_.vocabulary.static_relations();
    for (size_t i = 0; i < relations.size(); ++i) {
      if (relations[i].argument_types.size() < 2) continue;
      ForEachTuple(roles.size(), relations[i].argument_types.size(),
                   [&](const std::vector<size_t>& places) {
                     Literal literal = LiteralOf(i, places);
                     literal.is_static = true;
                     if (Mentions(literal, 0) &&
                         relations[i].facts.contains(ObjectsAt(places, roles)))
                       statics.insert(std::move(literal));
                   });
    }
    return statics;
  }

  static Literal LiteralOf(size_t relation, const std::vector<size_t>& places) {
    Literal literal;
    literal.relation = static_cast<int>(relation);
    for (const size_t place : places) {
      literal.terms.push_back({Term::Kind::kVariable, static_cast<int>(place)});
    }
    return literal;
  }
  static std::vector<int> ObjectsAt(const std::vector<size_t>& places,
                                    const Binding& roles) {
    std::vector<int> objects;
    for (const size_t place : places) objects.push_back(roles[place]);
    return objects;
  }

  EventChain ChainOf(const Binding& roles) const {
    EventChain lifted;
    const EventChain rows = manipulation_.chain.RowsOf(manipulation_.part);
    for (size_t column = 0; column < rows.num_columns(); ++column) {
      TouchGraph graph;
      for (size_t row = 0; row < rows.num_rows(); ++row) {
        const auto& [first, second] = rows.pairs()[row];
        const std::string name =
            TypeNameOf(first == manipulation_.part ? second : first, roles);
        if (name.empty()) continue;
        Relation& relation = graph
                                 .try_emplace(MakePair(Showing::kMoved, name),
                                              Relation::kNotTouching)
                                 .first->second;
        const Relation seen = rows.At(row, column);
        if (relation == Relation::kNotTouching) relation = seen;
      }
      lifted.Append(graph);
    }
    return lifted.ChangingRows().DistinctColumns();
  }

  /// Empty: of a hand.
  std::string TypeNameOf(const std::string& name, const Binding& roles) const {
    if (name == SceneObjects::kTable) return name;
    const Part* part = words_.parts.Find(name);
    if (part == nullptr) return "";
    for (size_t i = 1; i < roles.size(); ++i) {
      if (words_.PartOf(roles[i]) != name) continue;
      const Object& object = words_.vocabulary.objects()[roles[i]];
      return words_.vocabulary.types().name(object.type);
    }
    return part->type;
  }

  const ObservedManipulation& manipulation_;
  const SceneWords& words_;
};

EventChain Backwards(const EventChain& chain) {
  EventChain backwards;
  for (size_t column = chain.num_columns(); column > 0; --column) {
    TouchGraph graph;
    for (size_t row = 0; row < chain.num_rows(); ++row) {
      graph[chain.pairs()[row]] = chain.At(row, column - 1);
    }
    backwards.Append(graph);
  }
  return backwards;
}

}  // namespace

Showing Showing::Reversed() const {
  Showing reversed = *this;
  std::swap(reversed.pick, reversed.place);
  for (const Literal& literal : pick.where) {
    if (!literal.is_static) continue;
    reversed.place.where.erase(literal);
    reversed.pick.where.insert(literal);
  }
  reversed.chain = Backwards(chain);
  return reversed;
}

std::optional<Showing> Lift(const ObservedManipulation& manipulation,
                            const SceneWords& words) {
  return Lifter(manipulation, words).Lift();
}

}  // namespace cell
