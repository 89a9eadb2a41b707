// The robot's plan and when it is made again; the sensed state and when it is
// requested.
#include "services/planner/current_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planner/sensing.h"
#include "tests/unit/bench_domain.h"

namespace cell {

using namespace planner;
namespace {

/// Finds as many expected actions as its problem's rule set has the version.
class CountingSolver final : public Solver {
 public:
  CountingSolver(Problem problem, int* num_found)
      : problem_(std::move(problem)), num_found_(num_found) {}
  Plan Find(const State&) override {
    ++*num_found_;
    Plan plan;
    plan.result = Plan::Result::kFound;
    plan.expected_actions = static_cast<double>(problem_.rules->version());
    plan.reason = problem_.goal.name;
    plan.steps.resize(problem_.blocked.size());
    return plan;
  }
  Plan FindWithoutReason(const State& state) override { return Find(state); }

 private:
  Problem problem_;
  int* num_found_;
};

class CurrentPlanTest : public testing::Test {
 protected:
  BenchDomain bench_;
  int num_found_ = 0;
  CurrentPlan plan_{bench_.rules, bench_.GoalOf("done"), [this](Problem p) {
                      return std::make_unique<CountingSolver>(std::move(p),
                                                              &num_found_);
                    }};
  State state_ = bench_.StateOf({});
  std::set<GroundAction> blocked_ = {bench_.Action("Close", {"lid"})};
};

TEST_F(CurrentPlanTest, IsMadeOnceForAState) {
  EXPECT_FALSE(plan_.IsFor(state_, {}));
  plan_.Find(state_, {});
  plan_.Find(state_, {});
  EXPECT_EQ(num_found_, 1);
  EXPECT_TRUE(plan_.IsFor(state_, {}));
  plan_.Find(bench_.StateOf({"Closed(lid)"}), {});
  EXPECT_EQ(num_found_, 2);
}

TEST_F(CurrentPlanTest, IsMadeAgainWithoutBlockedActions) {
  plan_.Find(state_, {});
  EXPECT_FALSE(plan_.IsFor(state_, blocked_));
  EXPECT_EQ(plan_.Find(state_, blocked_).steps.size(), 1u);
  EXPECT_TRUE(plan_.FindUnblocked(state_).steps.empty());
  EXPECT_EQ(plan_.get().steps.size(), 1u);
}

TEST_F(CurrentPlanTest, IsMadeAgainForAnotherGoalAndByOtherRules) {
  plan_.Find(state_, {});
  plan_.SetGoal(bench_.GoalOf("one"));
  EXPECT_FALSE(plan_.IsFor(state_, {}));
  EXPECT_EQ(plan_.Find(state_, {}).reason, "one");
  plan_.SetRules(BenchDomain(kBench, 5).rules);
  EXPECT_FALSE(plan_.IsFor(state_, {}));
  EXPECT_EQ(plan_.get().result, Plan::Result::kUndecided);
  EXPECT_EQ(plan_.Find(state_, {}).expected_actions, 5);
}

TEST_F(CurrentPlanTest, IsReportedWhenItIsAnotherOne) {
  const SensedState sensed{3, 30, state_};
  plan_.Find(state_, {});
  const auto reported = plan_.TakeIfNew(sensed);
  ASSERT_TRUE(reported.has_value());
  EXPECT_EQ(reported->key_frame, 3);
  EXPECT_EQ(reported->utime, 30);
  EXPECT_FALSE(plan_.TakeIfNew(sensed).has_value());
  plan_.Find(bench_.StateOf({"Closed(lid)"}), {});  // the same plan
  EXPECT_FALSE(plan_.TakeIfNew(sensed).has_value());
  plan_.Find(state_, blocked_);
  EXPECT_TRUE(plan_.TakeIfNew(sensed).has_value());
}

TEST(Sensing, GivesTheLatestStateIfItIsYoungEnough) {
  Sensing sensing(100);
  EXPECT_EQ(sensing.Fresh(), nullptr);
  sensing.Update({1, 99, State(1)});
  EXPECT_EQ(sensing.Fresh(), nullptr);
  sensing.Update({2, 100, State(1)});
  sensing.Update({3, 99, State(1)});  // it comes late
  ASSERT_NE(sensing.Fresh(), nullptr);
  EXPECT_EQ(sensing.Fresh()->key_frame, 2);
  sensing.RequireSince(150);
  sensing.RequireSince(120);
  EXPECT_EQ(sensing.Fresh(), nullptr);
  EXPECT_FALSE(sensing.IsDue({149, 0}));
  EXPECT_TRUE(sensing.IsDue({150, 0}));
}

TEST(Sensing, AsksOncePerPeriod) {
  Sensing sensing(0);
  const auto asks = [&](int64_t utime, int64_t period) {
    Decisions out;
    sensing.Ask({utime, 0}, period, out);
    return out.sense;
  };
  EXPECT_TRUE(asks(0, 10));
  EXPECT_FALSE(asks(9, 10));
  EXPECT_TRUE(asks(10, 10));
  EXPECT_FALSE(asks(25, 20));
  EXPECT_TRUE(asks(25, 10));
}

}  // namespace
}  // namespace cell
