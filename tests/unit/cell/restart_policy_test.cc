// Deaths for a lasting reason, and how the reason reaches the user.
#include "services/cell/running/restart_policy.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "services/cell/running/process_output.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Optional;

ProcessGroup::Death Ended(int exit_code) {
  return {.name = "recorder", .exit_code = exit_code};
}

TEST(RestartPolicy, EndsWithTheSecondDeathForOneReason) {
  RestartPolicy policy;
  EXPECT_EQ(policy.WhyNot(Ended(1), "recorder: a/cell-0001.lcmlog: full"),
            std::nullopt);
  EXPECT_THAT(policy.WhyNot(Ended(1), "recorder: a/cell-0002.lcmlog: full"),
              Optional(HasSubstr("cell-0002.lcmlog: full")));
}

TEST(RestartPolicy, StartsAgainWhatDiesForAnotherReasonOrIsKilled) {
  RestartPolicy policy;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(policy.WhyNot(Ended(1), "lost"), std::nullopt);
    EXPECT_EQ(policy.WhyNot({.name = "recorder"}, "lost"), std::nullopt);
    EXPECT_EQ(policy.WhyNot(Ended(1), "no answer"), std::nullopt);
  }
}

TEST(RestartPolicy, EndsAtOnceForWrongArgumentsAndFilesAndMissingPrograms) {
  for (const int exit_code : {2, 127}) {
    EXPECT_THAT(RestartPolicy().WhyNot(Ended(exit_code), "a.yaml:b: missing"),
                Optional(HasSubstr("a.yaml:b: missing")));
  }
}

TEST(RestartPolicy, GivesUpServicesThatAreKilledRepeatedly) {
  RestartPolicy policy;
  int num_restarts = 0;
  while (!policy.WhyNot({.name = "recorder"}, "") && num_restarts < 100) {
    ++num_restarts;
  }
  EXPECT_EQ(num_restarts, 10);
}

TEST(ProcessOutput, LinesComeByThePipeWhereTheFileHasNoRoom) {
  ProcessOutput output;
  const int end = output.Open("recorder", "/dev/full");
  ASSERT_EQ(write(end, "one\ntwo\nthr", 11), 11);
  EXPECT_THAT(output.TakeLines(), ElementsAre("one", "two"));
  EXPECT_EQ(output.LastLineOf("recorder"), "two");
  EXPECT_THAT(output.TakeLines(), IsEmpty());
  close(end);
  EXPECT_THAT(output.TakeLines(), ElementsAre("thr"));
  EXPECT_EQ(output.LastLineOf("recorder"), "thr");
  EXPECT_EQ(output.LastLineOf("tracker"), "");
}

}  // namespace
}  // namespace cell
