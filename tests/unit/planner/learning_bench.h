#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/experiences/task_experience.h"
#include "services/planner/knowledge.h"
#include "tests/unit/bench_domain.h"

namespace cell {

// The bench whose Insert and Close nobody has shown yet.
inline const std::string kUnlearnedBench = kBenchTypes + R"yaml(
constants: {bolt_1: bolt, bolt_2: bolt, bolt_3: bolt, lid: lid, box.hole_1: hole,
            box.hole_2: hole, box.top: object, left: arm, right: arm}
)yaml" + kBenchPredicates + R"yaml(
  Clear: {arguments: [part]}
actions:
  Insert:
    arguments: {X: bolt, Y: hole}
    skill: {name: insert, part: X, site: Y, arm: right}
  Close:
    arguments: {X: lid}
    skill: {name: insert, part: X, site: box.top, arm: right}
)yaml" + kPresentOfBench + R"yaml(
goals:
  done: ["In(_, box.hole_1)", "In(_, box.hole_2)", Closed(lid)]
)yaml";

/// A bench that learns from what is shown.
struct LearningBench {
  BenchDomain bench{kUnlearnedBench};
  planner::Knowledge knowledge{bench.domain, true};
  std::shared_ptr<const RuleSet> rules = bench.rules;

  /// All bolts and the lid lie free and within reach of the right arm.
  State Start(const std::set<std::string>& is_true = {}) const {
    std::set<std::string> all = is_true;
    for (const char* part : {"bolt_1", "bolt_2", "bolt_3", "lid"}) {
      all.insert(std::string("Clear(") + part + ")");
      all.insert(std::string("Reachable(right, ") + part + ")");
    }
    return bench.StateOf(all);
  }
  State With(State state, const std::string& atom, bool is_true = true) const {
    const State only = bench.StateOf({atom});
    for (int i = 0; i < state.num_atoms(); ++i) {
      if (only.Get(i) == Truth::kTrue) {
        state.Set(i, is_true ? Truth::kTrue : Truth::kFalse);
      }
    }
    return state;
  }
  TaskExperience Experience(const std::string& action,
                            const std::vector<std::string>& objects,
                            const State& before, const State& after) const {
    TaskExperience experience{action, {}, Agent::kPerson, before, after};
    for (const std::string& name : objects) {
      experience.objects.push_back(bench.Object(name));
    }
    return experience;
  }
  /// The bolt goes into the hole.
  TaskExperience Inserted(const std::string& bolt, const std::string& hole,
                          const State& before) const {
    return Experience("Insert", {bolt, hole}, before,
                      With(before, "In(" + bolt + ", " + hole + ")"));
  }
  void Learn(const TaskExperience& experience) {
    knowledge.Add(++num_experiences, experience);
    if (auto changed = knowledge.TakeChange(rules->version() + 1)) {
      rules = std::move(changed);
    }
  }
  const planner::Exploration Exploring() const {
    return {.experiences = knowledge.experiences()};
  }

  int num_experiences = 0;
};

}  // namespace cell
