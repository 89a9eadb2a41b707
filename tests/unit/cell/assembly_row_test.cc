#include "services/cell/evaluations/assembly_row.h"

#include <gmock/gmock.h>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PartsNamedIn, ATextAreThoseOfWhichItNamesTheWholeName) {
  const ShippedTask task;
  EXPECT_THAT(PartsNamedIn("please take the shaft out; raise square_peg_1.",
                           task.parts),
              ElementsAre("shaft", "square_peg_1"));
  EXPECT_THAT(PartsNamedIn("square_peg is no part", task.parts), IsEmpty());
}

TEST(PartsNamedIn, ASiteDoesNotNameItsHost) {
  const ShippedTask task;
  EXPECT_THAT(
      PartsNamedIn("remove what is in or over the hole base.round_1; take the "
                   "round_peg_1 out of the hole base.round_1",
                   task.parts),
      ElementsAre("round_peg_1"));
  EXPECT_THAT(PartsNamedIn("the base has moved", task.parts),
              ElementsAre("base"));
}

}  // namespace
}  // namespace cell
