#include "common/experiences/rule_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell {
namespace {

constexpr const char* kArgumentNames[] = {"X", "Y", "Z"};

bool IsLeftOut(const Predicate& predicate) {
  return predicate.report.has_value();
}

/// All sites: objects that are named "part.site".
std::vector<int> SitesOf(const Vocabulary& vocabulary) {
  std::vector<int> sites;
  for (size_t i = 0; i < vocabulary.objects().size(); ++i) {
    if (vocabulary.objects()[i].name.find('.') != std::string::npos) {
      sites.push_back(static_cast<int>(i));
    }
  }
  return sites;
}

/// "Insert 2 action <-- bolt(X) hole(Y)"
std::string DeclarationOf(const Action& action, const Vocabulary& vocabulary) {
  std::string text =
      fmt::format("{} {} action", action.name, action.arguments.size());
  for (size_t i = 0; i < action.arguments.size(); ++i) {
    const int type = action.arguments[i].type;
    if (i >= rules::kMaxArity || type == TypeHierarchy::kObject) continue;
    text += text.find("<--") == std::string::npos ? " <--" : "";
    text += fmt::format(" {}({})", vocabulary.types().name(type),
                        kArgumentNames[i]);
  }
  return text + "\n";
}

std::string DeclarationsOf(const Vocabulary& vocabulary,
                           std::span<const Action> actions) {
  std::string text;
  for (const int site : SitesOf(vocabulary)) {
    text +=
        vocabulary.objects()[static_cast<size_t>(site)].name + " 0 constant\n";
  }
  for (const StaticRelation& relation : vocabulary.static_relations()) {
    text += fmt::format("{} {} primitive\n", relation.name,
                        relation.argument_types.size());
  }
  for (const Predicate& predicate : vocabulary.predicates()) {
    if (IsLeftOut(predicate)) continue;
    text += fmt::format("{} {} primitive\n", predicate.name,
                        predicate.argument_types.size());
  }
  for (const Action& action : actions) {
    text += DeclarationOf(action, vocabulary);
  }
  return text;
}

}  // namespace

RuleWorld::RuleWorld(std::shared_ptr<const Vocabulary> vocabulary,
                     std::span<const Action> actions)
    : vocabulary_(std::move(vocabulary)),
      actions_(actions.begin(), actions.end()) {
  const auto symbols =
      std::make_shared<const rules::SymbolTable>(rules::SymbolTable::Parse(
          DeclarationsOf(*vocabulary_, actions), "domain.yaml"));
  from_object_ = SitesOf(*vocabulary_);
  to_object_.assign(vocabulary_->objects().size(), -1);
  std::vector<std::string> others;
  for (size_t i = 0; i < vocabulary_->objects().size(); ++i) {
    const int object = static_cast<int>(i);
    if (std::ranges::count(from_object_, object) > 0) continue;
    from_object_.push_back(object);
    others.push_back(vocabulary_->objects()[i].name);
  }
  for (size_t i = 0; i < from_object_.size(); ++i) {
    to_object_[static_cast<size_t>(from_object_[i])] = static_cast<int>(i);
  }
  world_ = std::make_shared<const rules::World>(symbols, others);
  FindPlaces();
  SetStaticFacts();
}

void RuleWorld::FindPlaces() {
  for (int i = 0; i < vocabulary_->num_atoms(); ++i) {
    const GroundAtom atom = vocabulary_->Atom(i);
    const Predicate& predicate =
        vocabulary_->predicates()[static_cast<size_t>(atom.predicate)];
    if (IsLeftOut(predicate)) continue;
    std::vector<int> objects;
    for (const int object : atom.objects) {
      objects.push_back(to_object_[static_cast<size_t>(object)]);
    }
    const int symbol = *world_->symbols().Find(predicate.name);
    atoms_.push_back({i, world_->PlaceOf(symbol, objects)});
  }
}

void RuleWorld::SetStaticFacts() {
  static_facts_ = world_->EmptyState();
  for (const StaticRelation& relation : vocabulary_->static_relations()) {
    const int symbol = *world_->symbols().Find(relation.name);
    for (const std::vector<int>& fact : relation.facts) {
      std::vector<int> objects;
      for (const int object : fact) {
        objects.push_back(to_object_[static_cast<size_t>(object)]);
      }
      rules::World::Set(&static_facts_, world_->PlaceOf(symbol, objects), true);
    }
  }
}

rules::WorldState RuleWorld::ToWorld(const State& state) const {
  rules::WorldState world = static_facts_;
  for (const auto& [atom, place] : atoms_) {
    if (state.Get(atom) == Truth::kTrue) {
      rules::World::Set(&world, place, true);
    }
  }
  return world;
}

State RuleWorld::FromWorld(const rules::WorldState& state) const {
  State result(vocabulary_->num_atoms());
  for (const auto& [atom, place] : atoms_) {
    if (rules::World::Get(state, place)) result.Set(atom, Truth::kTrue);
  }
  return result;
}

rules::GroundAct RuleWorld::ToWorld(const GroundAction& action) const {
  const std::string& name =
      actions_.at(static_cast<size_t>(action.action)).name;
  rules::GroundAct act{*world_->symbols().Find(name), {}};
  for (const int object : action.arguments) {
    act.arguments.push_back(to_object_.at(static_cast<size_t>(object)));
  }
  return act;
}

GroundAction RuleWorld::FromWorld(const rules::GroundAct& act) const {
  GroundAction action{ActionOf(act.action), {}};
  for (const int object : act.arguments) {
    action.arguments.push_back(ObjectOf(object));
  }
  return action;
}

rules::Experience RuleWorld::ToExperience(const State& before,
                                          const GroundAction& action,
                                          const State& after) const {
  State known_before = before;
  State known_after = after;
  for (const int atom : before.UnknownAtoms()) {
    known_before.Set(atom, after.Get(atom));
  }
  for (const int atom : after.UnknownAtoms()) {
    known_after.Set(atom, before.Get(atom));
  }
  return {ToWorld(known_before), ToWorld(action), ToWorld(known_after)};
}

int RuleWorld::ObjectOf(int world_object) const {
  return from_object_.at(static_cast<size_t>(world_object));
}

std::optional<int> RuleWorld::PredicateOf(int symbol) const {
  return vocabulary_->FindPredicate(world_->symbols()[symbol].name);
}

std::optional<int> RuleWorld::StaticOf(int symbol) const {
  return vocabulary_->FindStatic(world_->symbols()[symbol].name);
}

const std::vector<int>& RuleWorld::ArgumentTypes(int symbol) const {
  if (const auto predicate = PredicateOf(symbol)) {
    return vocabulary_->predicates()[static_cast<size_t>(*predicate)]
        .argument_types;
  }
  return vocabulary_->static_relations()[static_cast<size_t>(*StaticOf(symbol))]
      .argument_types;
}

int RuleWorld::ActionOf(int symbol) const {
  const auto it = std::ranges::find(actions_, world_->symbols()[symbol].name,
                                    &Action::name);
  return static_cast<int>(it - actions_.begin());
}

}  // namespace cell
