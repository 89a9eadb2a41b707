#pragma once

#include "common/rexd/rexd_task.h"

namespace cell::rexd {

struct TestRunParams {
  /// Of the planner, for each plan.
  int64_t max_expansions = 1000;
  /// After so many actions the run has failed.
  int max_actions = 100;
  uint64_t seed = 1;
};

struct TestRun {
  bool is_goal_reached = false;
  int num_actions = 0;
};

/// Plans with rules that were learned as if their likeliest outcomes were
/// certain, and again where something else happens (FF-Replan: Yoon, Fern,
/// Givan, ICAPS 2007), in the world of the task, whose rules are true. Nothing
/// is learned.
/// @param rules  with the symbols of the task
TestRun RunTest(const rules::NdrRules& rules, const RexdTask& task,
                const TestRunParams& params = {});

}  // namespace cell::rexd
