#include "services/cell/scoring/assembly_observer.h"

#include <gmock/gmock.h>

#include <map>

#include "cell/asked_skill_t.hpp"
#include "cell/skill_result_t.hpp"
#include "tests/unit/cell/fed_messages.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class AssemblyObserverTest : public testing::Test {
 protected:
  template <class M>
  void Put(const std::string& channel, const M& message) {
    observer_.Put(LoggedMessage(channel, message, utime_));
  }
  /// Half a second in which nothing moves.
  void Rest() {
    for (int i = 0; i < 5; ++i) {
      utime_ += 100'000;
      Put("TRUTH_POSES", TruthOf(stage_, task_.parts));
    }
  }
  void End(int64_t id, const std::string& skill, int8_t outcome,
           double peak_force = 0) {
    asked_skill_t request{};
    request.id = id;
    request.skill = skill;
    Put("SKILL_REQUEST", request);
    Rest();
    skill_result_t result{};
    result.id = id;
    result.outcome = outcome;
    result.peak_force = peak_force;
    Put("SKILL_RESULT", result);
    Rest();
  }
  void Insert(int64_t id) { End(id, "insert", skill_result_t::SUCCEEDED); }

  ShippedTask task_;
  Stage stage_{task_};
  SuccessCriterion success_ = SuccessCriterion::Load(ShippedDeployment());
  AssemblyObserver observer_{success_};
  int64_t utime_ = 0;
};

TEST_F(AssemblyObserverTest, ThereIsNoScoreBeforeTwoSnapshots) {
  EXPECT_FALSE(observer_.Score());
  Rest();
  ASSERT_TRUE(observer_.Score());
  EXPECT_THAT(observer_.Score()->seated, IsEmpty());
}

TEST_F(AssemblyObserverTest, WhatComesLooseWithALaterStepIsBroken) {
  stage_.Seat("shaft", "base.shaft");
  Insert(1);
  stage_.Seat("round_peg_1", "base.round_1");
  Insert(2);
  EXPECT_THAT(observer_.record().broken, IsEmpty());
  stage_.Lift("shaft", 0.002);
  stage_.Seat("round_peg_2", "base.round_2");
  Insert(3);
  EXPECT_THAT(observer_.record().broken, ElementsAre("base.shaft"));
  Insert(4);  // the same once more is nothing new
  EXPECT_THAT(observer_.record().broken, ElementsAre("base.shaft"));
  EXPECT_THAT(observer_.Score()->seated,
              ElementsAre("base.round_1", "base.round_2"));
}

TEST_F(AssemblyObserverTest, CountsWhatWasAskedAndHowItEnded) {
  Insert(1);
  End(2, "present", skill_result_t::REFUSED);
  End(3, "insert", skill_result_t::FAILED, 42);
  End(4, "insert", skill_result_t::STOPPED, 12);
  End(5, "insert", skill_result_t::YIELDED, 12);
  const AssemblyObserver::Record& record = observer_.record();
  EXPECT_EQ(record.num_requests, 5);
  EXPECT_EQ(record.num_refused, 1);
  EXPECT_EQ(record.num_failed, 1);
  EXPECT_EQ(record.num_stopped, 1);
  EXPECT_EQ(record.num_yielded, 1);
  EXPECT_EQ(record.peak_force, 42);
}

}  // namespace
}  // namespace cell
