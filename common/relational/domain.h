#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/relational/request_words.h"
#include "common/relational/rule.h"

namespace cell {

/// The literals to be reached, all at once; `_` means any object.
struct Goal {
  std::string name;
  std::vector<Literal> literals;
};

/// The symbolic level of a task: domain.yaml. How its actions are recognised is
/// learned: sec_models.yaml. So may be the rules of its actions: LoadTask().
///
///   types: {part: object, bolt: part, hole: object}
///   constants: {inspector: object}                # optional
///   static_facts:                                 # optional
///     fits: {arguments: [part, hole], of_parts: fits}   # or host
///     near: {arguments: [hole, hole], facts: [[a.h, b.h]]}
///   predicates:
///     InHole: {arguments: [bolt, hole], geometry: ...}
///     Held: {arguments: [part, arm], reported: held}      # or reachable
///   actions:
///     Insert:
///       arguments: {X: bolt, Y: hole}
///       agents: [person, robot]                   # default: both
///       undoes: Remove                            # optional
///       rules:                                    # optional
///         - agents: [person]                     # default: the action's
///           context: [fits(X, Y), Free(Y), not InHole(X, _)]
///           references: {Z: {type: part, such_that: [On(X, Z)]}}  # optional
///           outcomes:
///             - probability: 0.95
///               effects:
///                 - InHole(X, Y)
///                 - {each: {U: part}, where: [On(U, X)], then: [Hot(U)]}
///           noise: 0.05
///       skill: {name: insert, part: X, site: Y, arm: right}   # optional
///       # Optional: what a robot needs besides, one of these; and what its
///       # success changes besides.
///       robot:
///         - {context: [Held(X, right)], effects: [not Held(X, right)]}
///   requests: ...                                 # optional: RequestWords
///   goals:
///     done: [InHole(_, a.h)]
class Domain {
 public:
  /// The blocks `geometry` are left unread: LoadTask() reads them.
  /// @throws ConfigError naming file:key.
  static Domain FromConfig(const Config& config, const PartTable& parts);

  /// Replaces the action of that name, or appends a new one; indices stay.
  /// Returns true if that changes the domain.
  bool Put(const Action& action);

  const Vocabulary& vocabulary() const { return vocabulary_; }
  const std::vector<Action>& actions() const { return actions_; }
  const std::vector<Goal>& goals() const { return goals_; }
  const RequestWords& requests() const { return requests_; }
  std::optional<int> FindAction(const std::string& name) const;
  /// Nothing if there is none of that name.
  const Goal* FindGoal(const std::string& name) const;

  /// All combinations of objects that the arguments' types allow and for which
  /// some rule's static literals hold; in the order of actions and objects.
  std::vector<GroundAction> GroundActions(Agent agent) const;
  /// How an arm does it; nothing if none can.
  std::optional<GroundSkill> SkillOf(const GroundAction& action) const;
  /// The action with these objects; nothing unless names, number and types
  /// are right.
  std::optional<GroundAction> FindGroundAction(
      const std::string& name, const std::vector<std::string>& objects) const;
  /// "Insert(bolt_1, frame.hole_1)"
  std::string Show(const GroundAction& action) const;

 private:
  Vocabulary vocabulary_;
  std::vector<Action> actions_;
  std::vector<Goal> goals_;
  RequestWords requests_;
};

/// Reads an action of domain.yaml, without `undoes` and `sec`.
/// @throws ConfigError naming file:key.
Action LoadAction(const std::string& name, const Config& config,
                  const Vocabulary& vocabulary);

}  // namespace cell
