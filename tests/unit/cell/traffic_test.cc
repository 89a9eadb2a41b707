// What `cell top` shows of the messages that it receives.
#include "services/cell/running/traffic.h"

#include <gmock/gmock.h>

#include <string>

#include "common/bus/bus.h"
#include "services/cell/running/traffic_table.h"

namespace cell {

using namespace cli;
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr size_t kNumServices = 3;
constexpr int kColumns = 80;

Bytes Health(int64_t cpu_us, int32_t sender = 1) {
  health_t health{};
  health.header.sender = sender;
  health.service = "tracker";
  health.cpu_us = cpu_us;
  return Bus::Encode(health);
}

TEST(Traffic, ComputesProcessorSharesFromTwoHealthsByTheirOwnTimes) {
  Traffic traffic(kNumServices);
  traffic.OnControl("HEALTH", Health(4'000'000), 0.25);
  EXPECT_FALSE(traffic.KnowsProcessorTimes());
  const Traffic::Report first = traffic.MakeReport(1);
  ASSERT_EQ(first.processes.size(), 1u);
  EXPECT_EQ(first.processes[0].processor, std::nullopt);
  EXPECT_THAT(TrafficTable(first, kColumns),
              testing::ContainsRegex("tracker +\\? "));

  traffic.OnControl("HEALTH", Health(4'500'000), 2.25);
  EXPECT_TRUE(traffic.KnowsProcessorTimes());
  EXPECT_EQ(traffic.MakeReport(0.1).processes[0].processor, 0.25);
  // Without another one it is what was known last.
  EXPECT_EQ(traffic.MakeReport(0.1).processes[0].processor, 0.25);
}

TEST(Traffic, ANewIncarnationCountsFromItsFirstHealth) {
  Traffic traffic(kNumServices);
  traffic.OnControl("HEALTH", Health(9'000'000), 1);
  traffic.OnControl("HEALTH", Health(100'000, 1001), 2);
  EXPECT_FALSE(traffic.KnowsProcessorTimes());
  traffic.OnControl("HEALTH", Health(600'000, 1001), 3);
  EXPECT_EQ(traffic.MakeReport(1).processes[0].processor, 0.5);
}

TEST(Traffic, WhereNoCellIsHeardOneLineSaysSo) {
  Traffic traffic(kNumServices);
  EXPECT_TRUE(traffic.KnowsProcessorTimes());
  EXPECT_THAT(TrafficTable(traffic.MakeReport(1), kColumns),
              AllOf(HasSubstr("no cell is heard"), HasSubstr("--url"),
                    Not(HasSubstr("CPU"))));
}

}  // namespace
}  // namespace cell
