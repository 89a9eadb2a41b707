#include "services/cell/evaluations/stop_choice.h"

#include <gmock/gmock.h>

#include <set>
#include <string>
#include <utility>

namespace cell {

using namespace cli;

namespace {

using Seen = std::set<std::pair<std::string, StopKind>>;

/// In `num_runs` runs with `per_run` skills of the kind each.
Seen SeenIn(StoppedSkill skill, uint64_t num_runs, int per_run) {
  Seen seen;
  for (uint64_t seed = 1; seed <= num_runs; ++seed) {
    for (int i = 0; i < per_run; ++i) {
      const StopChoice choice = ChooseStop(skill, seed, i);
      seen.insert({choice.stage, choice.kind});
    }
  }
  return seen;
}

TEST(StopChoice, FewRunsStopEveryStageOfASkillInEveryWay) {
  constexpr size_t kKinds = 3;
  EXPECT_EQ(SeenIn(StoppedSkill::kInsert, 5, 8).size(), 10 * kKinds);
  EXPECT_EQ(SeenIn(StoppedSkill::kInsertTurning, 36, 1).size(), 7 * kKinds);
  EXPECT_EQ(SeenIn(StoppedSkill::kSetDown, 24, 1).size(), 8 * kKinds);
}

TEST(StopChoice, IsTheSameForTheSameSeed) {
  for (int i = 0; i < 8; ++i) {
    const StopChoice a = ChooseStop(StoppedSkill::kInsert, 7, i);
    const StopChoice b = ChooseStop(StoppedSkill::kInsert, 7, i);
    EXPECT_EQ(a.stage, b.stage);
    EXPECT_EQ(a.delay, b.delay);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.duration, b.duration);
  }
}

}  // namespace
}  // namespace cell
