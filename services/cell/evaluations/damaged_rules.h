#pragma once

#include "common/rexd/rexd_task.h"
#include "common/rules/simulation.h"
#include "services/cell/evaluations/excuse_case.h"

namespace cell::cli {

/// Noisy deictic rules. Their guidance is that of the learner (section VI-B1),
/// their planner that of rexd::RuleModel.
class DamagedRules final : public DamagedDomain {
 public:
  explicit DamagedRules(rexd::RexdTask task);

  std::optional<ExcuseCase> Draw(uint64_t seed) const override;

 private:
  struct Damaged;
  std::optional<Damaged> DamageRules(rules::RandomNumbers* random) const;
  rules::WorldState DrawState(rules::RandomNumbers* random) const;

  rexd::RexdTask task_;
  std::vector<rules::GroundAct> acts_;
};

}  // namespace cell::cli
