#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/relational/rule.h"
#include "common/relational/state.h"
#include "common/relational/vocabulary.h"
#include "common/rules/experience.h"

namespace cell {

/// A task's vocabulary and actions as the world that rules are learned in
/// (section V-C). Sites are constants, which rules may name; the other objects
/// are those of the scene. Types and static relations become predicates that
/// never change. Predicates that an arm reports of itself belong to its skills
/// and are left out.
class RuleWorld {
 public:
  /// @throws rules::RuleError for names and numbers of arguments that
  /// rules::SymbolTable does not take.
  RuleWorld(std::shared_ptr<const Vocabulary> vocabulary,
            std::span<const Action> actions);

  const std::shared_ptr<const rules::World>& world() const { return world_; }
  const Vocabulary& vocabulary() const { return *vocabulary_; }
  const std::vector<Action>& actions() const { return actions_; }

  /// What is unknown is taken as false.
  rules::WorldState ToWorld(const State& state) const;
  /// Atoms of predicates that are left out are false.
  State FromWorld(const rules::WorldState& state) const;
  rules::GroundAct ToWorld(const GroundAction& action) const;
  GroundAction FromWorld(const rules::GroundAct& act) const;
  /// An atom that is unknown before or after has not changed.
  rules::Experience ToExperience(const State& before,
                                 const GroundAction& action,
                                 const State& after) const;

  /// Places among the vocabulary's objects, predicates and static relations, of
  /// those of the world; an unnamed optional is of the other kind.
  int ObjectOf(int world_object) const;
  std::optional<int> PredicateOf(int symbol) const;
  std::optional<int> StaticOf(int symbol) const;
  /// Of a predicate or a static relation.
  const std::vector<int>& ArgumentTypes(int symbol) const;
  /// Place among the actions.
  int ActionOf(int symbol) const;

 private:
  struct AtomPlace {
    int atom;   ///< of the vocabulary
    int place;  ///< in a state of the world
  };

  void FindPlaces();
  void SetStaticFacts();

  std::shared_ptr<const Vocabulary> vocabulary_;
  std::vector<Action> actions_;
  std::shared_ptr<const rules::World> world_;
  std::vector<int> from_object_;  // vocabulary's, of each of the world
  std::vector<int> to_object_;
  std::vector<AtomPlace> atoms_;
  rules::WorldState static_facts_;
};

}  // namespace cell
