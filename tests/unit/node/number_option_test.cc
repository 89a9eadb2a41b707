// Errors of options for numbers that they cannot take.
#include "common/node/number_option.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace cell {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::string ErrorOf(const CLI::Validator& check, std::string text) {
  return check(text);
}

TEST(NumberOption, NamesTheLimitsThatAreSet) {
  EXPECT_EQ(ErrorOf(NumberIn(1), "0"),
            "'0' is out of range; should be a whole number of at least 1");
  EXPECT_EQ(ErrorOf(NumberIn(1, 256), "0"),
            "'0' is out of range; should be a whole number from 1 to 256");
  EXPECT_EQ(ErrorOf(NumberIn(0.), "-1"),
            "'-1' is out of range; should be a number of at least 0");
  EXPECT_EQ(ErrorOf(NumberIn(0.1, 60.), "0"),
            "'0' is out of range; should be a number from 0.1 to 60");
}

TEST(NumberOption, NeverPrintsTheLimitsOfFloatingPoint) {
  for (const auto& check :
       {NumberIn<double>(), NumberIn(0.), NumberIn(0.1), NumberIn(0., 60.)}) {
    EXPECT_THAT(ErrorOf(check, "x"), SizeIs(testing::Lt(100u)));
    EXPECT_THAT(check.get_description(), SizeIs(testing::Lt(30u)));
  }
}

TEST(NumberOption, SaysWhatTheTypeHoldsWhereNothingElseLimitsIt) {
  EXPECT_THAT(ErrorOf(NumberIn<uint64_t>(), "18446744073709551616"),
              HasSubstr("from 0 to 18446744073709551615"));
}

}  // namespace
}  // namespace cell
