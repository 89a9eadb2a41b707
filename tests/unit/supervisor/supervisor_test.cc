#include "services/supervisor/supervisor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "common/bus/stepper.h"

namespace cell {

using namespace supervisor;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr char kRoster[] = R"yaml(
task: bench
services:
  - {name: clock, latency: 1}
  - {name: eyes, latency: 1}
  - {name: mind, latency: 5}
  - {name: supervisor, latency: 1}
  - {name: robot_arm@left, latency: 1}
  - {name: diary, latency: 1}
)yaml";
constexpr char kTable[] = R"yaml(
silence_ms: 1200
operator_hold: at_once
services:
  eyes: {when_silent: at_boundary, level: error, means: nobody sees}
  mind: {when_silent: at_boundary, level: error, means: nobody decides}
  robot_arm@left: {when_silent: at_once, level: error, means: no arm,
                   silence_ms: 250}
  diary: {when_silent: alert_only, level: warning, means: nobody writes}
)yaml";

Roster TheRoster() {
  return Roster::FromConfig(Config::Parse(kRoster, "roster.yaml"));
}

StopPolicy Table(const std::string& text) {
  const Config config = Config::Parse(text, "supervisor.yaml");
  StopPolicy table = StopPolicy::FromConfig(config, TheRoster(), "supervisor");
  config.Finish();
  return table;
}

/// A supervisor on a bus, in a cell whose services are alive unless a test says
/// otherwise.
class Supervised : public testing::Test {
 protected:
  Supervised() {
    Supervisor::Params params{Table(kTable), 40'000, {}, {"left"}};
    for (const auto& entry : TheRoster().entries) {
      params.services.push_back(entry.name);
    }
    service_ = std::make_unique<Supervisor>(stepper_, params);
  }

  template <class M>
  void Give(const std::string& channel, const M& message) {
    inputs_.push_back(*MessageFromWire(channel, Bus::Encode(message)));
  }
  void Tick(int num_ticks = 1) {
    for (int i = 0; i < num_ticks; ++i) {
      ++tick_;
      Live();
      ASSERT_EQ(stepper_.Accept(tick_, std::exchange(inputs_, {})),
                Stepper::State::kReady);
      for (const Message& m : stepper_.Run()) {
        if (m.channel == "MOTION_PERMIT") Decode(m, permits_.emplace_back());
        if (m.channel == "MODE") Decode(m, modes_.emplace_back());
        if (m.channel == "ALERT") Decode(m, alerts_.emplace_back());
      }
    }
  }
  void Live() {
    if (has_device_ && tick_ == 1) ArmServo(arm_state_t::FOLLOWING);
    for (const char* name : {"eyes", "mind", "diary"}) {
      if (tick_ % 62 != 7 || dead_ == name) continue;
      status_t status{};
      status.service = name;
      Give("STATUS", status);
    }
    const bool is_due = tick_ % 12 == 0 || (has_device_ && tick_ == 1);
    if (is_due && dead_ != "robot_arm@left") Report();
  }
  template <class M>
  void Decode(const Message& message, M& decoded) {
    ASSERT_GT(decoded.decode(message.bytes->data(), 0,
                             static_cast<int>(message.bytes->size())),
              0);
  }

  void Episode(int8_t phase, const std::string& agent) {
    episode_t episode{};
    episode.phase = phase;
    episode.agent = agent;
    Give("EPISODE", episode);
  }
  void Command(int8_t action, int64_t in_us = 1'000'000) {
    command_mode_t command{};
    command.action = action;
    command.deadline_utime = now() + in_us;
    Give("COMMAND_MODE", command);
  }
  void ArmServo(int8_t servo) {
    arm_state_t state{};
    state.servo = servo;
    Give("ARM_STATE_LEFT", state);
  }
  void Report(bool is_held_by_operator = false) {
    arm_report_t report{};
    report.arm = "left";
    report.is_held_by_operator = is_held_by_operator;
    Give("ARM_REPORT_LEFT", report);
  }
  void Result(int8_t outcome) {
    skill_result_t result{};
    result.arm = "left";
    result.outcome = outcome;
    Give("SKILL_RESULT", result);
  }
  int64_t NumRejected() const {
    int64_t num = 0;
    for (const auto& [channel, n] : stepper_.num_rejected()) num += n;
    return num;
  }
  int64_t now() const { return tick_ * kTickUs; }
  const motion_permit_t& permit() const { return permits_.back(); }

  Stepper stepper_{{.name = "supervisor"}};
  std::unique_ptr<Service> service_;
  std::vector<Message> inputs_;
  std::vector<motion_permit_t> permits_;
  std::vector<operating_mode_t> modes_;
  std::vector<alert_t> alerts_;
  std::string dead_;
  bool has_device_ = true;
  int32_t tick_ = 0;
};

TEST_F(Supervised, GivesAPermitOfFortyMillisecondsEveryTick) {
  Tick(300);
  ASSERT_THAT(permits_, SizeIs(300));
  for (size_t i = 0; i < permits_.size(); ++i) {
    const int64_t utime = static_cast<int64_t>(i + 1) * kTickUs;
    EXPECT_EQ(permits_[i].header.utime, utime);
    EXPECT_EQ(permits_[i].until_utime, utime + 40'000);
  }
  EXPECT_THAT(alerts_, IsEmpty());
}

TEST_F(Supervised, ARestartPermitsNothingBeforeEveryArmHasReported) {
  has_device_ = false;
  Episode(episode_t::RUNNING, "robot");
  Tick(3);
  Report();
  Tick();
  EXPECT_THAT(permits_, IsEmpty());
  ArmServo(arm_state_t::STOPPED);
  Tick();
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  EXPECT_FALSE(permit().is_held_by_operator);
}

TEST_F(Supervised, ARestartKeepsTheOperatorsHold) {
  has_device_ = false;
  Episode(episode_t::RUNNING, "robot");
  ArmServo(arm_state_t::FOLLOWING);
  Tick(3);
  EXPECT_THAT(permits_, IsEmpty());
  EXPECT_THAT(modes_, IsEmpty());
  Report(true);
  Tick();
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  EXPECT_TRUE(permit().is_held_by_operator);
  // The arm's later reports only repeat the resumed hold.
  Command(command_mode_t::RESUME);
  Report(true);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  EXPECT_FALSE(permit().is_held_by_operator);
}

TEST_F(Supervised, TheModeFollowsTheEpisode) {
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::IDLE);
  Episode(episode_t::START, "person");
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::MONITOR);
  Episode(episode_t::END, "person");
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::IDLE);
  Episode(episode_t::RUNNING, "robot");  // after an own restart
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  EXPECT_EQ(modes_.back().mode, motion_permit_t::EXECUTE);
  EXPECT_THAT(modes_, SizeIs(4));
}

TEST_F(Supervised, SaysTheModeWhenItChangesAndAtLeastEachSecond) {
  Tick(1000);
  int64_t last = 0;
  for (const operating_mode_t& mode : modes_) {
    EXPECT_LE(mode.header.utime - last, 1'000'000);
    last = mode.header.utime;
  }
  EXPECT_GE(now() - last, 0);
  EXPECT_LE(now() - last, 1'000'000);
}

TEST_F(Supervised, HoldsAtTheNextBoundaryWhileAServiceIsSilent) {
  Episode(episode_t::START, "robot");
  Tick(100);
  dead_ = "eyes";
  const int64_t death = now();
  while (alerts_.empty() && now() < death + 3'000'000) Tick();
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_LE(now() - death, 1'500'000);
  EXPECT_EQ(alerts_[0].cause, alert_t::SERVICE_SILENT);
  EXPECT_EQ(alerts_[0].level, alert_t::ERROR);
  EXPECT_THAT(alerts_[0].text, HasSubstr("eyes"));
  EXPECT_THAT(alerts_[0].text, HasSubstr("nobody sees"));
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  EXPECT_EQ(permit().hold, motion_permit_t::AT_BOUNDARY);
  EXPECT_EQ(permit().until_utime, now() + 40'000);
  EXPECT_THAT(modes_.back().reason, HasSubstr("eyes"));
  Tick(200);
  EXPECT_THAT(alerts_, SizeIs(1));
  // It ends by itself.
  dead_.clear();
  Tick(100);
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  EXPECT_EQ(modes_.back().hold, motion_permit_t::NONE);
  ASSERT_THAT(alerts_, SizeIs(2));
  EXPECT_EQ(alerts_[1].level, alert_t::INFO);
}

TEST_F(Supervised, HoldsAtOnceWhileAnArmIsSilent) {
  Episode(episode_t::START, "robot");
  Tick(100);
  dead_ = "robot_arm@left";
  const int64_t death = now();
  while (alerts_.empty() && now() < death + 3'000'000) Tick();
  EXPECT_LE(now() - death, 350'000);
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  EXPECT_LE(permit().until_utime, now());
}

TEST_F(Supervised, OnlyReportsTheSilenceOfServicesThatAreNotNeeded) {
  Episode(episode_t::START, "robot");
  Tick(100);
  dead_ = "diary";
  Tick(250);
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_EQ(alerts_[0].level, alert_t::WARNING);
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
}

TEST_F(Supervised, NoServiceIsDeadRightAfterTheSupervisorsStart) {
  tick_ = 10'000;  // a restart
  dead_ = "eyes";
  Tick(150);
  EXPECT_THAT(alerts_, IsEmpty());
  Tick(2);
  EXPECT_THAT(alerts_, SizeIs(1));
}

TEST_F(Supervised, AnOperatorsHoldLastsUntilItIsResumed) {
  Episode(episode_t::START, "robot");
  Tick();
  Command(command_mode_t::HOLD);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  EXPECT_LE(permit().until_utime, now());
  EXPECT_THAT(modes_.back().reason, HasSubstr("operator"));
  Command(command_mode_t::HOLD);
  Tick(500);
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  ASSERT_THAT(alerts_, SizeIs(1));
  EXPECT_EQ(alerts_[0].cause, alert_t::HELD);
  Episode(episode_t::END, "robot");
  Episode(episode_t::START, "robot");
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  Command(command_mode_t::RESUME);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  EXPECT_EQ(permit().until_utime, now() + 40'000);
}

TEST_F(Supervised, ResumingDoesNotEndTheHoldForADeadService) {
  Episode(episode_t::START, "robot");
  dead_ = "mind";
  Tick(200);
  Command(command_mode_t::HOLD);
  Tick();
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  Command(command_mode_t::RESUME);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  EXPECT_EQ(permit().hold, motion_permit_t::AT_BOUNDARY);
}

TEST_F(Supervised, RefusesCommandsAfterTheirDeadlineAndUnknownOnes) {
  Tick(10);
  Command(command_mode_t::HOLD, 0);
  Tick();  // a tick later it is too late
  Command(7);
  Tick();
  EXPECT_EQ(NumRejected(), 2);
  EXPECT_EQ(permit().mode, motion_permit_t::IDLE);
}

TEST_F(Supervised, AProtectiveStopNamesTheLimitAndWhatWasMeasured) {
  Episode(episode_t::START, "robot");
  Tick();
  arm_stop_t stop{};
  stop.arm = "left";
  stop.limit = "stop_force_n";
  stop.where = "the gripper of the left arm";
  stop.unit = "N";
  stop.measured = 12.004;
  stop.allowed = 12;
  ArmServo(arm_state_t::STOPPED);
  Give("ARM_STOP_LEFT", stop);
  Tick();
  const std::string why =
      "the gripper of the left arm measured 12.004 N, more than the 12.000 N "
      "allowed (stop_force_n)";
  EXPECT_THAT(modes_.back().reason, HasSubstr(why));
  EXPECT_THAT(alerts_.back().text, HasSubstr(why));
  const auto num_rejected = NumRejected();
  stop.measured = 11;  // no reason to stop
  Give("ARM_STOP_LEFT", stop);
  Tick();
  EXPECT_EQ(NumRejected(), num_rejected + 1);
}

TEST_F(Supervised, AProtectiveStopNeedsThePerson) {
  Episode(episode_t::START, "robot");
  Tick();
  ArmServo(arm_state_t::STOPPED);
  Tick();
  EXPECT_EQ(permit().hold, motion_permit_t::AT_ONCE);
  EXPECT_THAT(modes_.back().reason, HasSubstr("the left arm"));
  EXPECT_EQ(alerts_.back().level, alert_t::ERROR);
  ArmServo(arm_state_t::FOLLOWING);
  Tick();
  ArmServo(arm_state_t::STOPPED);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
  Command(command_mode_t::RESUME);
  ArmServo(arm_state_t::STOPPED);  // the device is about to clear it
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  ArmServo(arm_state_t::FOLLOWING);
  Tick();
  ArmServo(arm_state_t::STOPPED);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
}

TEST_F(Supervised, ASkillThatStopsUnasksForThePersonUnlessAHoldStoppedIt) {
  Episode(episode_t::START, "robot");
  Tick();
  Command(command_mode_t::HOLD);
  Tick();
  Result(skill_result_t::STOPPED);
  Tick();
  Command(command_mode_t::RESUME);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  Tick(50);
  Result(skill_result_t::FAILED);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::EXECUTE);
  Result(skill_result_t::STOPPED);
  Tick();
  EXPECT_EQ(permit().mode, motion_permit_t::HOLD);
}

TEST_F(Supervised, RejectsWhatCannotBe) {
  Tick();
  status_t status{};
  status.service = "nobody";
  Give("STATUS", status);
  arm_report_t report{};
  report.arm = "right";
  Give("ARM_REPORT_LEFT", report);
  ArmServo(9);
  Result(9);
  Episode(9, "robot");
  Episode(episode_t::START, "cat");
  skill_result_t result{};
  result.arm = "third";
  Give("SKILL_RESULT", result);
  Tick();
  EXPECT_EQ(NumRejected(), 7);
  EXPECT_EQ(permit().mode, motion_permit_t::IDLE);
}

std::string ErrorOf(const std::string& what, const std::string& instead) {
  std::string text = kTable;
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), instead);
  try {
    Table(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(StopPolicy, NamesEveryServiceOfTheRosterAndNoOther) {
  EXPECT_THAT(Table(kTable).rows, SizeIs(4));
  EXPECT_THAT(ErrorOf("  eyes:", "  ears:"),
              HasSubstr("services.ears: is not in the roster"));
  EXPECT_THAT(ErrorOf("  diary:", "  supervisor:"),
              HasSubstr("cannot be watched from here"));
  EXPECT_THAT(
      ErrorOf("  diary: {when_silent: alert_only, level: warning, means: "
              "nobody writes}\n",
              ""),
      HasSubstr("lacks 'diary'"));
}

TEST(StopPolicy, PassesOverThoseThatDoNotTakePart) {
  const auto num_rows = [](const std::string& option) {
    const Roster roster = Roster::FromConfig(Config::Parse(
        kRoster + ("  - {name: lamp, latency: 1" + option + "}\n"),
        "roster.yaml"));
    const Config config = Config::Parse(
        kTable + std::string("  lamp: {when_silent: alert_only, level: info, "
                             "means: it is dark}\n"),
        "supervisor.yaml");
    const size_t num =
        StopPolicy::FromConfig(config, roster, "supervisor").rows.size();
    config.Finish();
    return num;
  };
  EXPECT_EQ(num_rows(", option: light"), 4u);
  EXPECT_EQ(num_rows(""), 5u);
}

TEST(StopPolicy, RefusesUnknownWordsAndKeys) {
  EXPECT_THAT(ErrorOf("at_boundary", "soon"),
              HasSubstr("'soon' is not one of"));
  EXPECT_THAT(ErrorOf("level: error", "level: bad"),
              HasSubstr("'bad' is not one of"));
  EXPECT_THAT(ErrorOf("operator_hold: at_once", "operator_hold: alert_only"),
              HasSubstr("must stop the arms"));
  EXPECT_THAT(ErrorOf("silence_ms: 250", "silence_s: 250"),
              HasSubstr("silence_s: not known"));
  EXPECT_THAT(ErrorOf("silence_ms: 1200", "silence_ms: 0"),
              HasSubstr("silence_ms"));
}

TEST(StopPolicy, TheShippedOneFitsTheShippedRoster) {
  Stepper stepper({.name = "supervisor"});
  EXPECT_NE(MakeSupervisor(
                stepper, Deployment{CELL_SOURCE_DIR "/deploy/config", "", ""}),
            nullptr);
}

}  // namespace
}  // namespace cell
