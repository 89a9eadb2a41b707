#include "common/bus/arrivals.h"

#include <gtest/gtest.h>

#include "common/bus/roster.h"
#include "tests/unit/toy_services.h"

namespace cell {
namespace {

Message From(int32_t sender, int32_t seq, const char* channel = "A") {
  Bytes bytes = Bus::Encode(toy::Number(0, 1));
  WriteIdentity(0, sender, seq, bytes);
  return *MessageFromWire(channel, std::move(bytes));
}

TEST(Arrivals, AcceptsEachMessageOnce) {
  Arrivals arrivals(3);
  for (int32_t seq = 0; seq < 5; ++seq) {
    EXPECT_TRUE(arrivals.Accept(From(1, seq)));
    EXPECT_FALSE(arrivals.Accept(From(1, seq)));
  }
  EXPECT_EQ(arrivals.num_repeated(), 5);
  EXPECT_TRUE(arrivals.num_lost().empty());
}

TEST(Arrivals, CountsWhatWasSkippedUntilItComes) {
  Arrivals arrivals(3);
  EXPECT_TRUE(arrivals.Accept(From(1, 7)));  // joined late: nothing is lost
  EXPECT_TRUE(arrivals.Accept(From(1, 10)));
  EXPECT_EQ(arrivals.num_lost().at("A"), 2);
  EXPECT_TRUE(arrivals.Accept(From(1, 9)));
  EXPECT_EQ(arrivals.num_lost().at("A"), 1);
  EXPECT_FALSE(arrivals.Accept(From(1, 9)));
}

TEST(Arrivals, ANewIncarnationBeginsAtZero) {
  Arrivals arrivals(3);
  EXPECT_TRUE(arrivals.Accept(From(1, 900)));
  EXPECT_TRUE(arrivals.Accept(From(1001, 0)));
  EXPECT_TRUE(arrivals.Accept(From(1001, 1)));
  EXPECT_TRUE(arrivals.num_lost().empty());
  EXPECT_FALSE(arrivals.Accept(From(1, 901)));  // of the dead one
}

TEST(Arrivals, AForgedSeqDoesNotBlockTheTrueOnes) {
  Arrivals arrivals(3);
  EXPECT_TRUE(arrivals.Accept(From(1, 0)));
  EXPECT_FALSE(arrivals.Accept(From(1, INT32_MAX)));
  EXPECT_FALSE(arrivals.Accept(From(5001, 77)));
  EXPECT_TRUE(arrivals.Accept(From(1, 1)));
  EXPECT_EQ(arrivals.num_unknown_senders(), 2);
}

TEST(Arrivals, AForgedFirstMessageDoesNotBlockTheTrueOnes) {
  Arrivals arrivals(3);
  EXPECT_TRUE(arrivals.Accept(From(9001, 123456)));
  EXPECT_FALSE(arrivals.Accept(From(1, 5)));
  EXPECT_TRUE(arrivals.Accept(From(1, 6)));
  EXPECT_TRUE(arrivals.Accept(From(1, 7)));
}

TEST(Arrivals, RefusesSendersThatAreNotInTheRoster) {
  Arrivals arrivals(3);
  EXPECT_FALSE(arrivals.Accept(From(3, 0)));
  EXPECT_FALSE(arrivals.Accept(From(-1, 0)));
  EXPECT_FALSE(arrivals.Accept(From(1, -1)));
  EXPECT_EQ(arrivals.num_unknown_senders(), 3);
}

TEST(Arrivals, DoesNotGrowWithoutBound) {
  Arrivals arrivals(3);
  for (int i = 0; i < 10'000; ++i) {
    arrivals.Accept(From(1, 0, ("C" + std::to_string(i)).c_str()));
  }
  EXPECT_GT(arrivals.num_unknown_senders(), 5'000);
}

}  // namespace
}  // namespace cell
