#pragma once

#include <optional>
#include <vector>

#include "services/cell/explaining/explainer.h"
#include "services/planner/decision_basis.h"

namespace cell::cli {

/// Explains what a planner decided, from what it decided by: why arms were
/// asked for an action, why a person was asked or warned, what a plan is worth.
class DecisionExplainer final : public Explainer {
 public:
  /// `is_verbose`: also all alternatives, and why they are worse or impossible.
  explicit DecisionExplainer(bool is_verbose) : is_verbose_(is_verbose) {}

  /// For the planner whose decisions it explains. This object must outlive it.
  planner::DecisionObserver Observer();

  std::vector<int64_t> Utimes() const override;
  std::vector<Explanation> At(int64_t utime) const override;

 private:
  struct Observed {
    int64_t utime = 0;  // [us] when it was published
    planner::Decisions decisions;
    std::optional<planner::DecisionBasis> basis;
  };

  std::vector<Explanation> Explain(const Observed& observed,
                                   int64_t utime) const;
  Explanation ExplainRequest(const Observed& observed,
                             const planner::SkillRequest& request) const;
  Explanation ExplainPlan(const Observed& observed) const;
  Explanation ExplainQuestion(const Observed& observed) const;
  static Explanation ExplainAlert(const Observed& observed,
                                  const planner::Alert& alert);

  bool is_verbose_;
  std::vector<Observed> observed_;
};

}  // namespace cell::cli
