#pragma once

#include <memory>

#include "common/ppddl/problem.h"
#include "common/rules/simulation.h"
#include "services/cell/evaluations/excuse_case.h"

namespace cell::planning {
class GroundModel;
}

namespace cell::cli {

/// A PPDDL problem. Its guidance is that of `cell plan`.
class DamagedPpddl final : public DamagedDomain {
 public:
  /// @throws std::runtime_error if the problem is too large
  DamagedPpddl(ppddl::Domain domain, ppddl::Problem problem);

  std::optional<ExcuseCase> Draw(uint64_t seed) const override;

 private:
  struct Damaged;
  std::optional<Damaged> DamageDomain(rules::RandomNumbers* random) const;
  /// The problem from a state that random actions lead to.
  ppddl::Problem DrawProblem(rules::RandomNumbers* random) const;

  ppddl::Domain domain_;
  ppddl::Problem problem_;
  std::shared_ptr<const planning::GroundModel> model_;
};

}  // namespace cell::cli
