// Which skills an arm has, and why it refuses other requests.
#include "services/robot_arm/skills/skill_catalog.h"

#include <gmock/gmock.h>

#include "services/robot_arm/motions.h"
#include "services/robot_arm/stage_runner.h"

namespace cell {

using namespace robot_arm;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string WhyNot(const SkillRequest& request, bool has_force_sensor) {
  return WhyNoSkill(request, has_force_sensor).value_or("");
}

TEST(SkillCatalog, AnArmWithoutForceSensorHasAllButWhatNeedsOne) {
  const auto all = SkillsOf(true);
  const auto few = SkillsOf(false);
  EXPECT_EQ(all.size(), AllSkills().size());
  EXPECT_EQ(few.size(), all.size() - 1);
  const SkillRequest insert{1, "insert", {{"part", "p"}, {"site", "s"}}};
  EXPECT_EQ(WhyNot(insert, true), "");
  EXPECT_EQ(WhyNot(insert, false),
            "it has no force-torque sensor, which insert needs");
}

TEST(SkillCatalog, ASkillThatItHasNotIsRefusedWithThoseThatItHas) {
  const std::string why = WhyNot({1, "open_door", {}}, false);
  EXPECT_THAT(why, HasSubstr("no skill 'open_door'; it has present, put_down"));
  EXPECT_THAT(why, testing::Not(HasSubstr("insert")));
}

TEST(SkillCatalog, OtherArgumentsThanASkillTakesAreRefused) {
  EXPECT_EQ(WhyNot({1, "present", {}}, true),
            "present takes the arguments [part], not []");
  EXPECT_EQ(WhyNot({1, "go_home", {{"part", "p"}}}, true),
            "go_home takes the arguments [], not [part]");
  EXPECT_EQ(WhyNot({1, "insert", {{"hole", "s"}, {"part", "p"}}}, true),
            "insert takes the arguments [part, site], not [hole, part]");
}

TEST(SkillCatalog, OnlyWhatHandsOverMayRunBesideAnother) {
  for (const auto& skill : AllSkills()) {
    EXPECT_EQ(skill->traits().may_run_beside, skill->name() == "present")
        << skill->name();
    EXPECT_EQ(skill->traits().hands_over, skill->name() == "present");
  }
}

/// Runs for so many steps, then ends so.
class Steps : public SkillStage {
 public:
  Steps(int num, State end) : num_(num), end_(end) {}
  State Step(const ArmReading&, double, ArmCommand* command) override {
    command->opening += 1;
    return --num_ > 0 ? State::kRunning : end_;
  }
  Failure failure() const override { return {"it broke"}; }

 private:
  int num_;
  State end_;
};

class Runner : public testing::Test {
 protected:
  using Status = StageRunner::Status;

  void Add(const std::string& phase, int num, SkillStage::State end) {
    stages_.Add({{phase},
                 [=] { return std::make_unique<Steps>(num, end); },
                 [this, phase] {
                   done_.push_back(phase);
                 }});
  }
  Status Step() { return stages_.Step({}, 0.008, &command_); }

  StageRunner stages_;
  ArmCommand command_;
  std::vector<std::string> done_;
};

TEST_F(Runner, RunsStagesOneAfterTheOther) {
  Add("a", 2, SkillStage::State::kDone);
  Add("b", 1, SkillStage::State::kDone);
  EXPECT_FALSE(stages_.has_moved());
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_TRUE(stages_.has_moved());
  EXPECT_EQ(stages_.phase().name, "a");
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_THAT(done_, testing::ElementsAre("a"));
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_EQ(stages_.phase().name, "b");
  EXPECT_EQ(Step(), Status::kDone);
  EXPECT_EQ(command_.opening, 3);
}

TEST_F(Runner, AStageThatFailsEndsAllWithItsReason) {
  Add("a", 1, SkillStage::State::kFailed);
  Add("b", 1, SkillStage::State::kDone);
  EXPECT_EQ(Step(), Status::kFailed);
  EXPECT_EQ(stages_.failure().reason, "it broke");
  EXPECT_EQ(stages_.failure().cause, Failure::Cause::kOther);
  EXPECT_EQ(Step(), Status::kDone);
  EXPECT_THAT(done_, IsEmpty());
}

TEST_F(Runner, AStageThatCannotBeMadeEndsAllWithTheReason) {
  stages_.Add({{"a"}, []() -> StageRunner::Made {
                 return Reason{"nobody knows where it is"};
               }});
  EXPECT_EQ(Step(), Status::kFailed);
  EXPECT_EQ(stages_.failure().reason, "nobody knows where it is");
}

TEST_F(Runner, WaitsForAPersonAndThenNamesThemAsTheCause) {
  bool is_in_the_way = true;
  const auto wait = [&](double patience) {
    stages_.Add({{"a"}, [&, patience]() -> StageRunner::Made {
                   return std::make_unique<WaitForPerson>(
                       [&] { return is_in_the_way; }, patience);
                 }});
  };
  wait(0.012);
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_EQ(Step(), Status::kFailed);
  EXPECT_EQ(stages_.failure().cause, Failure::Cause::kPersonInTheWay);
  wait(0);
  EXPECT_EQ(Step(), Status::kFailed);
  EXPECT_FALSE(stages_.has_moved());
  is_in_the_way = false;
  wait(0);
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_EQ(Step(), Status::kDone);
}

TEST_F(Runner, WhereThereIsNothingToDoItGoesOnAtOnce) {
  stages_.Add({{"a"},
               [] { return std::unique_ptr<SkillStage>(); },
               [this] {
                 done_.push_back("a");
               }});
  Add("b", 1, SkillStage::State::kDone);
  EXPECT_EQ(Step(), Status::kRunning);
  EXPECT_THAT(done_, testing::ElementsAre("a", "b"));
}

}  // namespace
}  // namespace cell
