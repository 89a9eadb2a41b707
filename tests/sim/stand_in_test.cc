// A part of the assembly is taken for good: the cell asks for it, and names
// another that was never shown, but fits; a person places that one, and the
// cell goes on.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cell/execution_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "services/cell/running/task_variant.h"
#include "tests/sim/assembling_cell.h"
#include "tests/sim/skill_watch.h"

namespace cell {

using namespace cli;

namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr uint64_t kSeed = 3;

TEST(StandIn, IsProposedForAMissingPartAndCountedWhenAPersonPlacesIt) {
  const VariedTask varied(ShippedDeployment(), "thin_peg");
  AssemblingCell cell(kSeed, {}, varied.deployment(), "execution_taken");
  const SkillWatch skills(cell);
  std::vector<execution_t> questions;
  cell.On<execution_t>("EXECUTION", [&](const auto& m) {
    if (m.state == execution_t::STUCK) questions.push_back(m);
  });
  std::vector<recognised_action_t> placed;
  cell.On<recognised_action_t>("ACTION", [&](const auto& m) {
    if (std::ranges::count(m.arguments, "thin_peg_1") > 0) placed.push_back(m);
  });
  plan_t plan{};
  cell.On<plan_t>("PLAN", [&](const auto& m) { plan = m; });
  cell.Run();

  ASSERT_FALSE(questions.empty());
  EXPECT_THAT(questions[0].text,
              AllOf(HasSubstr("round_peg_"),
                    HasSubstr("; thin_peg_1 or thin_peg_2 could stand in for "
                              "round_peg_")));
  EXPECT_EQ(questions[0].help_part, "thin_peg_1");
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].kind, recognised_action_t::FORWARD);
  EXPECT_EQ(placed[0].name, "PlaceRoundPeg");
  EXPECT_EQ(placed[0].arguments.at(1), questions[0].help_site);
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_EQ(plan.result, plan_t::GOAL_REACHED);
}

}  // namespace
}  // namespace cell
