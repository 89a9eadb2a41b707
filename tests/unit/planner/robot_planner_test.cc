// The planner as a service in the robot's episodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "cell/alert_t.hpp"
#include "cell/answer_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/sense_request_t.hpp"
#include "common/bus/stepper.h"
#include "common/skills/skill_arguments.h"
#include "services/planner/execution_messages.h"
#include "services/planner/planner.h"
#include "tests/unit/cranfield_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int kPatienceTicks = 800;  // [ticks], after which a person is asked

/// A planner with the latency that it has in the cell. ArmStates report and
/// predicates are answered by the test.
class RobotPlanner : public testing::Test {
 protected:
  RobotPlanner() { Begin(); }

  void Begin() {
    stepper_ = std::make_unique<Stepper>(
        Stepper::Params{.name = "planner", .latency = 5});
    service_ = cranfield_.MakePlannerOfRules(*stepper_);
  }
  template <class M>
  void Give(const std::string& channel, M message) {
    message.header.utime = tick_ * kTickUs;
    message.header.seq = next_seq_++;
    inputs_.push_back(*MessageFromWire(channel, Bus::Encode(message)));
  }
  /// Time passes as it does in the cell.
  void Run(int num_ticks) {
    for (int i = 0; i < num_ticks; ++i) {
      if (tick_ % 12 == 0) {
        Give("ARM_REPORT_LEFT", left_);
        Give("ARM_REPORT_RIGHT", right_);
      }
      if (tick_ % 62 == 0) Give("MODE", mode_);
      ++tick_;
      const auto inputs = std::exchange(inputs_, {});
      if (stepper_->Accept(tick_, inputs) != Stepper::State::kReady) continue;
      for (const Message& m : stepper_->Run()) Keep(m);
    }
  }
  void Keep(const Message& m) {
    if (m.channel == "PLAN") Decode(m, plans_.emplace_back());
    if (m.channel == "ALERT") Decode(m, alerts_.emplace_back());
    if (m.channel == "ANSWER") Decode(m, answers_.emplace_back());
    if (m.channel == "EXECUTION") Decode(m, told_.emplace_back());
    if (m.channel == "SENSE_REQUEST") Give("PREDICATES", Predicates(state_));
    if (m.channel != "SKILL_REQUEST") return;
    Decode(m, requests_.emplace_back());
    Arm(requests_.back().arm).request = requests_.back().id;
  }
  template <class M>
  void Decode(const Message& message, M& decoded) {
    ASSERT_GT(decoded.decode(message.bytes->data(), 0,
                             static_cast<int>(message.bytes->size())),
              0);
  }

  void Start(const std::string& agent, const std::string& goal) {
    episode_t episode{};
    episode.id = 1;
    episode.phase = episode_t::START;
    episode.agent = agent;
    episode.goal = goal;
    Give("EPISODE", episode);
  }
  void Succeed(const std::string& arm) {
    skill_result_t result{};
    result.id = Arm(arm).request;
    result.arm = arm;
    Arm(arm).request = -1;
    Give("SKILL_RESULT", result);
  }
  /// What does not depend on the separator.
  void PlaceAllButTheUpperParts(const std::set<std::string>& left = {}) {
    const auto put = [&](const std::string& action,
                         const std::vector<std::string>& objects) {
      if (left.contains(objects[0])) return;
      state_ = cranfield_.Do(state_, action, objects);
    };
    put("PlaceRoundPeg", {"round_peg_1", "base.round_1"});
    put("PlaceRoundPeg", {"round_peg_2", "base.round_2"});
    put("PlaceRoundPeg", {"shaft", "base.shaft"});
    put("PlaceSquarePeg", {"square_peg_1", "base.square_1"});
    put("PlaceSquarePeg", {"square_peg_2", "base.square_2"});
    put("PlacePendulum", {"pendulum"});
    put("ScrewHead", {"head"});
  }
  void PutOutOfReach(const std::string& part) {
    std::erase(right_.reachable, part);
    --right_.num_reachable;
  }
  arm_report_t& Arm(const std::string& name) {
    return name == "left" ? left_ : right_;
  }
  static arm_report_t Idle(const std::string& arm,
                           const std::vector<std::string>& reachable) {
    arm_report_t report{};
    report.arm = arm;
    report.request = -1;
    report.reachable = reachable;
    report.num_reachable = static_cast<int32_t>(reachable.size());
    return report;
  }
  predicates_t Predicates(const State& state) const {
    predicates_t message{};
    const Vocabulary& v = cranfield_.domain->vocabulary();
    for (int i = 0; i < v.num_atoms(); ++i) {
      const GroundAtom atom = v.Atom(i);
      if (v.predicates()[atom.predicate].report) continue;
      literal_t& literal = message.literals.emplace_back();
      literal.predicate = v.predicates()[atom.predicate].name;
      for (const int object : atom.objects) {
        literal.arguments.push_back(v.objects()[object].name);
      }
      literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
      literal.value = static_cast<int8_t>(state.Get(i));
    }
    message.num_literals = static_cast<int32_t>(message.literals.size());
    return message;
  }

  Cranfield cranfield_;
  State state_ = cranfield_.Start();
  arm_report_t left_ = Idle("left", {});
  arm_report_t right_ = Idle(
      "right", {"face_plate", "head", "pendulum", "round_peg_1", "round_peg_2",
                "separator", "shaft", "square_peg_1", "square_peg_2"});
  operating_mode_t mode_ = [] {
    operating_mode_t mode{};
    mode.mode = motion_permit_t::EXECUTE;
    return mode;
  }();
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<Service> service_;
  std::vector<Message> inputs_;
  std::vector<plan_t> plans_;
  std::vector<alert_t> alerts_;
  std::vector<answer_t> answers_;
  std::vector<execution_t> told_;
  std::vector<asked_skill_t> requests_;
  int32_t tick_ = 0;
  int32_t next_seq_ = 0;
};

TEST_F(RobotPlanner, DoesTheWholeTask) {
  Start("robot", "assembled");
  std::vector<std::string> done;
  while (told_.empty() || told_.back().state != execution_t::DONE) {
    ASSERT_LT(tick_, 10'000);
    Run(100);
    for (const asked_skill_t& request : std::exchange(requests_, {})) {
      if (request.skill == "insert") {
        const std::string what = told_.back().action;
        for (const auto& action :
             cranfield_.domain->GroundActions(Agent::kRobot)) {
          if (cranfield_.domain->Show(action) != what) continue;
          state_ = cranfield_.Do(state_, action);
        }
        done.push_back(what);
      }
      Succeed(request.arm);
    }
  }
  EXPECT_THAT(done, SizeIs(9));
  EXPECT_EQ(done.back(), "PlaceFacePlate(face_plate)");
  EXPECT_THAT(alerts_, IsEmpty());
  EXPECT_EQ(plans_.front().num_steps, 9);
  EXPECT_EQ(plans_.back().result, plan_t::GOAL_REACHED);
}

TEST_F(RobotPlanner, RequestsTheSkillOfTheFirstStep) {
  Start("robot", "assembled");
  Run(100);
  ASSERT_THAT(requests_, SizeIs(1));
  EXPECT_EQ(requests_[0].arm, "right");
  EXPECT_EQ(requests_[0].skill, "insert");
  EXPECT_EQ(
      ArgumentsOf(requests_[0]),
      (SkillArguments{{"part", "round_peg_1"}, {"site", "base.round_1"}}));
  EXPECT_GT(requests_[0].deadline_utime, requests_[0].header.utime);
}

TEST_F(RobotPlanner, APersonsEpisodeMovesNoArm) {
  Start("person", "assembled");
  Give("PREDICATES", Predicates(state_));
  Run(300);
  EXPECT_THAT(requests_, IsEmpty());
  EXPECT_THAT(told_, IsEmpty());
  EXPECT_THAT(plans_, SizeIs(1));
}

TEST_F(RobotPlanner, AnUnknownAgentIsReportedOnce) {
  Start("cat", "assembled");
  Run(50);
  episode_t episode{};
  episode.id = 1;
  episode.phase = episode_t::RUNNING;
  episode.agent = "cat";
  Give("EPISODE", episode);
  Run(50);
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_EQ(alerts_[0].cause, alert_t::BAD_INPUT);
  EXPECT_THAT(alerts_[0].text, HasSubstr("'cat'"));
  EXPECT_THAT(requests_, IsEmpty());
}

TEST_F(RobotPlanner, ARestartGoesOnWithoutDoingAnythingTwice) {
  Start("robot", "assembled");
  Run(100);
  ASSERT_THAT(requests_, SizeIs(1));
  Begin();
  episode_t episode{};
  episode.phase = episode_t::RUNNING;
  episode.agent = "robot";
  episode.goal = "assembled";
  Give("EPISODE", episode);
  Run(200);
  EXPECT_THAT(requests_, SizeIs(1));
  state_ =
      cranfield_.Do(state_, "PlaceRoundPeg", {"round_peg_1", "base.round_1"});
  Succeed("right");
  Run(200);
  ASSERT_THAT(requests_, SizeIs(2));
  EXPECT_EQ(ArgumentOf(requests_[1], "part"), "round_peg_2");
  EXPECT_NE(requests_[0].id, requests_[1].id);
}

TEST_F(RobotPlanner, AsksForThePartThatNoArmReaches) {
  PlaceAllButTheUpperParts();
  PutOutOfReach("separator");
  Start("robot", "assembled");
  Run(kPatienceTicks);
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.back().state, execution_t::STUCK);
  EXPECT_EQ(told_.back().text,
            "separator is out of reach of both arms: please move it into "
            "reach");
  ASSERT_EQ(told_.back().num_needed, 1);
  EXPECT_EQ(told_.back().needed[0].predicate, "Reachable");
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_EQ(alerts_[0].cause, alert_t::STUCK);
  right_ = Idle("right",
                {"face_plate", "head", "pendulum", "round_peg_1", "round_peg_2",
                 "separator", "shaft", "square_peg_1", "square_peg_2"});
  Run(1000);  // until it is sure to stay there
  EXPECT_THAT(requests_, SizeIs(1));
}

TEST_F(RobotPlanner, AsksForNothingButThePartThatIsFarAway) {
  PlaceAllButTheUpperParts();
  PutOutOfReach("separator");
  state_ = cranfield_.With(state_, {"Clear(separator)"}, Truth::kFalse);
  Start("robot", "assembled");
  Run(kPatienceTicks);
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.back().text,
            "separator is out of reach of both arms: please move it into "
            "reach");
  EXPECT_EQ(told_.back().num_needed, 2);
}

TEST_F(RobotPlanner, AsksToRaiseWhatNoArmCanTakeSinceItLiesDown) {
  PutOutOfReach("square_peg_1");
  PlaceAllButTheUpperParts({"square_peg_1"});
  state_ = cranfield_.With(state_, {"Horizontal(square_peg_1)"});
  Start("robot", "assembled");
  Run(kPatienceTicks);
  ASSERT_FALSE(told_.empty());
  EXPECT_EQ(told_.back().text,
            "square_peg_1 is out of reach of both arms: please move it into "
            "reach; please stand the square_peg_1 upright");
}

TEST_F(RobotPlanner, TakesAnotherGoalByCommandAndRefusesLateOrUnknownOnes) {
  Start("robot", "assembled");
  Run(100);
  ASSERT_THAT(requests_, SizeIs(1));
  command_goal_t goal{};
  goal.goal = "round_pegs";
  goal.deadline_utime = (tick_ + 100) * kTickUs;
  Give("COMMAND_GOAL", goal);
  Run(20);
  // What runs is finished first; it was the first of the two.
  state_ =
      cranfield_.Do(state_, "PlaceRoundPeg", {"round_peg_1", "base.round_1"});
  Succeed("right");
  Run(150);
  ASSERT_FALSE(plans_.empty());
  EXPECT_EQ(plans_.back().num_steps, 1);
  goal.goal = "assembled";
  goal.deadline_utime = (tick_ - 1) * kTickUs;
  Give("COMMAND_GOAL", goal);
  Run(100);
  EXPECT_EQ(plans_.back().num_steps, 1);
  EXPECT_EQ(stepper_->num_rejected().at("COMMAND_GOAL"), 1);
  goal.goal = "nowhere";
  goal.deadline_utime = (tick_ + 100) * kTickUs;
  Give("COMMAND_GOAL", goal);
  Run(100);
  EXPECT_EQ(stepper_->num_rejected().at("COMMAND_GOAL"), 2);
  ASSERT_THAT(answers_, SizeIs(3));
  EXPECT_EQ(answers_[0].outcome, answer_t::ACCEPTED);
  EXPECT_THAT(answers_[1].text, HasSubstr("past its deadline"));
  EXPECT_THAT(answers_[2].text, HasSubstr("no goal 'nowhere'"));
}

TEST_F(RobotPlanner, AWatchedEpisodeMayGetAnotherGoal) {
  Start("person", "assembled");
  Give("PREDICATES", Predicates(state_));
  Run(50);
  command_goal_t goal{};
  goal.goal = "round_pegs";
  goal.deadline_utime = (tick_ + 100) * kTickUs;
  Give("COMMAND_GOAL", goal);
  Run(50);
  EXPECT_EQ(plans_.back().num_steps, 2);
}

TEST_F(RobotPlanner, RejectsForgedReportsAndResults) {
  const Vocabulary& vocabulary = cranfield_.rules->vocabulary();
  arm_report_t report = Idle("left", {"head", "shaft"});
  report.header.utime = 5;
  report.held = "pendulum";
  EXPECT_TRUE(FromMessage(report, vocabulary, 5).has_value());
  const auto is_report = [&](auto change) {
    arm_report_t forged = report;
    change(forged);
    return FromMessage(forged, vocabulary, 5).has_value();
  };
  using R = arm_report_t;
  EXPECT_FALSE(is_report([](R& r) { r.arm = "middle"; }));
  EXPECT_FALSE(is_report([](R& r) { r.held = "spoon"; }));
  EXPECT_FALSE(is_report([](R& r) { r.reachable[0] = "spoon"; }));
  EXPECT_FALSE(is_report([](R& r) { r.reachable[0] = "shaft"; }));
  EXPECT_FALSE(is_report([](R& r) { r.reachable[1] = "face_plate"; }));
  EXPECT_FALSE(is_report([](R& r) { r.request = -2; }));
  EXPECT_FALSE(is_report([](R& r) { r.header.utime = 6; }));
  EXPECT_FALSE(is_report([](R& r) { r.header.utime = -1; }));

  skill_result_t result{};
  result.arm = "right";
  result.peak_force = 12;
  EXPECT_TRUE(FromMessage(result, vocabulary, 5).has_value());
  const auto is_result = [&](auto change) {
    skill_result_t forged = result;
    change(forged);
    return FromMessage(forged, vocabulary, 5).has_value();
  };
  using S = skill_result_t;
  EXPECT_FALSE(is_result([](S& r) { r.arm = "table"; }));
  EXPECT_FALSE(is_result([](S& r) { r.outcome = 5; }));
  EXPECT_FALSE(is_result([](S& r) { r.outcome = -1; }));
  EXPECT_FALSE(is_result([](S& r) { r.id = -1; }));
  EXPECT_FALSE(is_result([](S& r) { r.header.utime = 6; }));
  EXPECT_FALSE(is_result(
      [](S& r) { r.peak_force = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_FALSE(is_result([](S& r) { r.peak_force = -1; }));
}

TEST_F(RobotPlanner, RejectsForgedModes) {
  operating_mode_t mode{};
  mode.mode = motion_permit_t::EXECUTE;
  EXPECT_EQ(MayActFromMessage(mode), true);
  mode.hold = motion_permit_t::AT_ONCE;
  EXPECT_EQ(MayActFromMessage(mode), std::nullopt);
  mode.mode = motion_permit_t::HOLD;
  EXPECT_EQ(MayActFromMessage(mode), false);
  mode.hold = 3;
  EXPECT_EQ(MayActFromMessage(mode), std::nullopt);
  mode.mode = 4;
  EXPECT_EQ(MayActFromMessage(mode), std::nullopt);
}

TEST_F(RobotPlanner, AReportOfTheOtherArmIsRejected) {
  Start("robot", "assembled");
  Run(20);
  Give("ARM_REPORT_LEFT", right_);
  Run(20);
  EXPECT_EQ(stepper_->num_rejected().at("ARM_REPORT_LEFT"), 1);
}

TEST_F(RobotPlanner, PublishesItsStatusAtLeastEachSecond) {
  int32_t last = 0;
  Start("robot", "assembled");
  for (int i = 0; i < 2000; ++i) {
    if (tick_ % 62 == 0) Give("MODE", mode_);
    ++tick_;
    const auto inputs = std::exchange(inputs_, {});
    if (stepper_->Accept(tick_, inputs) != Stepper::State::kReady) continue;
    for (const Message& m : stepper_->Run()) {
      if (m.channel != "STATUS") continue;
      EXPECT_LE(m.tick - last, 130);
      last = m.tick;
    }
  }
  EXPECT_GT(last, 1800);
}

}  // namespace
}  // namespace cell
