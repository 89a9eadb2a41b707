#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/actions/action_models.h"
#include "common/actions/action_record.h"
#include "common/experiences/learned_actions.h"
#include "common/experiences/task_experience.h"
#include "common/relational/domain.h"
#include "common/relational/rule_set.h"
#include "services/planner/stand_in_offer.h"

namespace cell::planner {

/// What the planner knows of actions: those of the task and of the library, and
/// if it learns, the rules that experiences give them (section V-C): those that
/// the task ships with, and those that the library keeps, count alike.
class Knowledge {
 public:
  /// @param shipped  experiences that the domain's rules were learned from;
  /// only those of a cell that learns are looked at. What they teach is learned
  /// here, not with the first change.
  Knowledge(Domain domain, bool is_learning,
            std::span<const TaskExperience> shipped = {});

  const Domain& domain() const { return domain_; }
  bool is_learning() const { return learned_.has_value(); }

  /// How actions show: those of the task, and from now on of the library. None
  /// is known before.
  void SetModels(ActionModels models);
  const std::shared_ptr<const SecModels>& sec_models() const {
    return sec_models_;
  }

  /// The library's record of an action. @throws ConfigError for names that the
  /// task does not have.
  void Put(const ActionRecord& record);
  /// An experience that the library keeps; one with a known id counts once.
  /// Only if it learns.
  void Add(int64_t id, const TaskExperience& experience);
  /// The library does not keep it any more.
  void Remove(int64_t id);

  /// If something has changed since the last call: all of it, as a rule set of
  /// this version; nullptr otherwise. Rules that the task has no words for are
  /// left out; why_not() says so.
  std::shared_ptr<const RuleSet> TakeChange(int64_t version);
  const std::optional<std::string>& why_not() const { return why_not_; }

  using Experiences = std::vector<TaskExperience>;
  /// All that have been learned from, by id.
  std::shared_ptr<const Experiences> experiences() const {
    return experiences_;
  }

 private:
  Domain WithLearnedRules();

  Domain domain_;                          // with the actions of the library
  std::optional<LearnedActions> learned_;  // if it learns
  std::optional<ActionModels> models_;
  std::shared_ptr<const SecModels> sec_models_;
  std::shared_ptr<const Experiences> experiences_;
  std::string source_ = "domain.yaml";  // of the last change
  bool has_changed_ = false;
  std::optional<std::string> why_not_;
};

}  // namespace cell::planner
