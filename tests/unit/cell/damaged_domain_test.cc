#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/cell/evaluations/damaged_ppddl.h"
#include "services/cell/evaluations/damaged_rules.h"
#include "services/cell/evaluations/excuse_figures.h"
#include "tests/unit/rexd/placing_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::cli {
namespace {

constexpr int kNumStates = 30;

void ExpectGoodExcuses(const DamagedDomain& domain) {
  std::vector<nlohmann::json> rows;
  for (uint64_t seed = 1; seed <= kNumStates; ++seed) {
    rows.push_back(ExcuseRow(domain, seed));
  }
  EXPECT_EQ(ExcuseRow(domain, 1), rows.front());
  const auto figures = SummariseExcuses(rows);
  EXPECT_GT(figures.size(), 2u);  // several kinds of damage
  EXPECT_EQ(figures.back().num_states, kNumStates);
  EXPECT_EQ(figures.back().num_good, kNumStates) << ExcuseText(figures);
}

TEST(DamagedRules, ExcusesAreMinimalAndNameWhatIsMissing) {
  ExpectGoodExcuses(DamagedRules(rexd::PlacingTask()));
}

TEST(DamagedPpddl, ExcusesAreMinimalAndHelp) {
  const auto domain = ppddl::ParseDomain(kCourier, "d");
  const auto problem = ppddl::ParseProblem(kDelivery, "p", domain);
  const DamagedPpddl damaged(domain, problem);
  for (uint64_t seed = 1; seed <= kNumStates; ++seed) {
    const auto row = ExcuseRow(damaged, seed);
    EXPECT_TRUE(row.at("minimal")) << row;
    EXPECT_TRUE(row.at("helps")) << row;
    EXPECT_GT(row.at("size"), 0) << row;
  }
}

class JudgedExcuse : public testing::Test {
 protected:
  void SetUp() override {
    for (uint64_t seed = 1; !case_ || case_->excuses.at(0).size() != 1;
         ++seed) {
      case_ = DamagedRules(rexd::PlacingTask()).Draw(seed);
    }
  }
  std::optional<ExcuseCase> case_;
};

TEST_F(JudgedExcuse, IsGoodAsFound) {
  const ExcuseVerdict verdict = Judge(*case_);
  EXPECT_TRUE(verdict.is_minimal && verdict.has_missing && verdict.is_named);
  EXPECT_EQ(verdict.size, 1);
}

TEST_F(JudgedExcuse, OfOneChangeTooManyIsNotMinimal) {
  planning::Changes& excuse = case_->excuses[0];
  const int other = excuse[0].atom == 0 ? 1 : 0;
  excuse.push_back({other, !case_->task.initial[static_cast<size_t>(other)]});
  case_->excuses.resize(1);
  EXPECT_FALSE(Judge(*case_).is_minimal);
}

TEST_F(JudgedExcuse, HoldsNothingOfAnotherDamage) {
  case_->missing = {"colour"};
  const ExcuseVerdict verdict = Judge(*case_);
  EXPECT_FALSE(verdict.has_missing || verdict.is_named);
  EXPECT_FALSE(verdict.may_hold_missing);
}

TEST_F(JudgedExcuse, IsNotNamedByAnotherText) {
  case_->text = "I know no way.";
  EXPECT_FALSE(Judge(*case_).is_named);
}

}  // namespace
}  // namespace cell::cli
