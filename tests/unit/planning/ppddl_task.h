#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "common/planning/ground_model.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/planner.h"
#include "common/ppddl/problem.h"

namespace cell::planning {

/// The task of a domain and a problem given as text.
inline GroundTask TaskOf(const std::string& domain_text,
                         const std::string& problem_text,
                         ConstantAtoms constants = ConstantAtoms::kReplace) {
  const auto domain = ppddl::ParseDomain(domain_text, "domain");
  const auto problem = ppddl::ParseProblem(problem_text, "problem", domain);
  const Result<GroundTask> task = GroundPpddl(domain, problem, constants);
  EXPECT_TRUE(task) << task.reason();
  return task ? *task : GroundTask{};
}

inline Plan PlanOf(const GroundTask& task, const Planner::Params& params = {}) {
  const auto model = std::make_shared<GroundModel>(task);
  return Planner(model, params).Find(model->initial());
}

/// A domain of propositions p0, p1, ... and actions "(:action ...)".
inline GroundTask Propositional(int num_atoms, const std::string& actions,
                                const std::string& init,
                                const std::string& goal) {
  std::string predicates;
  for (int i = 0; i < num_atoms; ++i) {
    predicates += " (p" + std::to_string(i) + ")";
  }
  return TaskOf(
      "(define (domain d) (:predicates" + predicates + ") " + actions + ")",
      "(define (problem p) (:domain d) (:init " + init + ") (:goal " + goal +
          "))");
}

}  // namespace cell::planning
