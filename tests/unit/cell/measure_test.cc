// What an evaluation says of a rate.
#include <gtest/gtest.h>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {
namespace {

TEST(Measure, IsMetOnlyWhereItsIntervalSaysSo) {
  EXPECT_EQ((Measure{"", 40, 40, {}, 0.9}.verdict()), "met");
  EXPECT_EQ((Measure{"", 40, 40, {}, 1}.verdict()),
            "no failure, but few trials");
  EXPECT_EQ((Measure{"", 19, 20, {}, 0.9}.verdict()), "met, but few trials");
  EXPECT_EQ((Measure{"", 17, 20, {}, 0.9}.verdict()), "NOT MET");
  EXPECT_EQ((Measure{"", 0, 0, {}, 0}.verdict()), "NOT MET");
}

}  // namespace
}  // namespace cell::cli
