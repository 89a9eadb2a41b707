#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/relational/rule.h"

namespace cell {

class Domain;

/// What actions do, as far as the cell knows: their symbols, rules and skills.
/// A value that never changes. It is held by shared_ptr, so that another one
/// of a higher version can replace it while a plan is made by this one.
class RuleSet {
 public:
  /// `source` names it in errors: a file, or a record. Literals of the actions
  /// are of the vocabulary.
  RuleSet(std::string source, int64_t version,
          std::shared_ptr<const Vocabulary> vocabulary,
          std::vector<Action> actions);
  /// The rules of a task's domain.yaml.
  static std::shared_ptr<const RuleSet> FromDomain(
      const Domain& domain, const std::string& source = "domain.yaml",
      int64_t version = 1);

  const std::string& source() const { return source_; }
  int64_t version() const { return version_; }
  const Vocabulary& vocabulary() const { return *vocabulary_; }
  const std::shared_ptr<const Vocabulary>& shared_vocabulary() const {
    return vocabulary_;
  }
  const std::vector<Action>& actions() const { return actions_; }
  const Action& ActionOf(const GroundAction& action) const {
    return actions_.at(static_cast<size_t>(action.action));
  }

  /// See ground_action.h.
  std::vector<GroundAction> GroundActions(Agent agent) const;
  std::optional<GroundAction> FindGroundAction(
      const std::string& name, const std::vector<std::string>& objects) const;
  /// How an arm does it; nullopt if none can.
  std::optional<GroundSkill> SkillOf(const GroundAction& action) const;
  /// "Insert(bolt_1, frame.hole_1)"
  std::string Show(const GroundAction& action) const;

  /// Why it cannot replace `current`, as "source:key: what is wrong; what would
  /// be right"; nullopt if it can: its version is higher, its vocabulary is the
  /// same, and it has all actions of `current` at their places, since ground
  /// actions refer to them. New ones may follow.
  std::optional<std::string> WhyNotReplace(const RuleSet& current) const;

 private:
  std::string source_;
  int64_t version_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  std::vector<Action> actions_;
};

}  // namespace cell
