#include "services/cell/scoring/alarm_score.h"

#include <gmock/gmock.h>

#include <map>
#include <optional>
#include <string>

#include "common/bus/bus.h"
#include "services/vtb/script.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int8_t kPlaced = truth_action_t::PLACED;
constexpr int8_t kTakenBack = truth_action_t::TAKEN_BACK;
constexpr int8_t kMoved = truth_action_t::MOVED;
constexpr int8_t kTipped = truth_action_t::TIPPED;

/// What a person does at full seconds, each shown by a key frame of its own,
/// and what the cell says.
class AlarmScoreTest : public testing::Test {
 protected:
  void Do(int8_t kind, const std::string& part, const std::string& site = "",
          int8_t mistake = truth_action_t::NONE) {
    utime_ += 1'000'000;
    ++key_frame_;
    record_.key_frame_ticks[key_frame_] = Tick();
    truth_action_t truth{};
    truth.header.utime = utime_;
    truth.kind = kind;
    truth.part = part;
    truth.site = site;
    truth.mistake = mistake;
    record_.truth_actions.push_back(truth);
    progress_.Update(truth);
    recognised_action_t action{};
    action.header.utime = utime_;
    action.part = part;
    action.place_key_frame = key_frame_;
    record_.actions.push_back(action);
  }
  void Say(int8_t level, int num_key_frames_later = 0) {
    for (int i = 0; i < num_key_frames_later; ++i) {
      record_.key_frame_ticks[++key_frame_] = Tick() + i;
    }
    alert_t alert{};
    alert.header.utime = utime_;
    alert.header.tick = Tick() + num_key_frames_later;
    alert.level = level;
    alert.cause =
        level == alert_t::ERROR ? alert_t::NO_PLAN : alert_t::LONGER_PLAN;
    record_.alerts.push_back(alert);
  }
  AlarmScore Score() const {
    return ScoreAlarms(record_, TrueProgress(demonstrations_, task_.parts));
  }
  int32_t Tick() const { return static_cast<int32_t>(utime_ / kTickUs); }

  ShippedTask task_;
  const vtb::Demonstrations demonstrations_ = vtb::Demonstrations::FromConfig(
      ShippedDeployment().OfTask("demonstrators.yaml"), task_.parts);
  TrueProgress progress_{demonstrations_, task_.parts};
  EpisodeRecord record_;
  int64_t utime_ = 0;
  int64_t key_frame_ = 0;
};

TEST_F(AlarmScoreTest, EveryValidPlacementBringsTheGoalNearer) {
  EXPECT_EQ(progress_.NumLeft(), 9);
  Do(kPlaced, "shaft", "base.shaft");
  EXPECT_EQ(progress_.NumLeft(), 8);
  Do(kPlaced, "pendulum", "base.pendulum");
  Do(kMoved, "head");
  EXPECT_EQ(progress_.NumLeft(), 7);
  EXPECT_TRUE(Score().is_faultless());
}

TEST_F(AlarmScoreTest, APartPlacedTooEarlyHasToBeTakenOutAgain) {
  Do(kPlaced, "pendulum", "base.pendulum", truth_action_t::OUT_OF_ORDER);
  EXPECT_EQ(progress_.NumLeft(), 10);
  Say(alert_t::WARNING);
  Do(kTakenBack, "pendulum", "base.pendulum");
  EXPECT_EQ(progress_.NumLeft(), 9);
  const AlarmScore score = Score();
  EXPECT_EQ(score.num_warnings_due, 1);
  EXPECT_EQ(score.num_warned, 1);
  EXPECT_TRUE(score.is_faultless());
}

TEST_F(AlarmScoreTest, APartThatLiesDownHasToBeRaised) {
  Do(kTipped, "round_peg_1");
  EXPECT_EQ(progress_.NumLeft(), 10);
  Do(kTipped, "round_peg_1");
  EXPECT_EQ(progress_.NumLeft(), 9);
}

TEST_F(AlarmScoreTest, APartOutsideTheWorkspaceIsADeadEnd) {
  Do(kMoved, "head", "", truth_action_t::OUT_OF_WORKSPACE);
  EXPECT_EQ(progress_.NumLeft(), std::nullopt);
  EXPECT_EQ(Score().num_missed, 1);
  Say(alert_t::ERROR);
  EXPECT_EQ(Score().num_called_errors, 1);
  EXPECT_TRUE(Score().is_faultless());
}

TEST_F(AlarmScoreTest, APartThatIsJammedIsADeadEndUntilItIsTakenAway) {
  Do(kMoved, "face_plate", "", truth_action_t::NOT_SEATED);
  EXPECT_EQ(progress_.NumLeft(), std::nullopt);
  Say(alert_t::ERROR);
  Do(kMoved, "face_plate");
  EXPECT_EQ(progress_.NumLeft(), 9);
  EXPECT_EQ(Score().num_errors_due, 1);
  EXPECT_EQ(Score().num_called_errors, 1);
  EXPECT_TRUE(Score().is_faultless());
}

TEST_F(AlarmScoreTest, TheWrongLevelIsNoSuccess) {
  Do(kMoved, "head", "", truth_action_t::OUT_OF_WORKSPACE);
  Say(alert_t::WARNING);
  EXPECT_EQ(Score().num_of_wrong_level, 1);
  EXPECT_EQ(Score().num_called_errors, 0);
  EXPECT_EQ(Score().num_missed, 0);
}

TEST_F(AlarmScoreTest, AnAlarmMoreThanOneKeyFrameLaterIsLate) {
  Do(kTipped, "round_peg_1");
  Say(alert_t::WARNING, 1);
  Do(kTipped, "round_peg_2");
  Say(alert_t::WARNING, 2);
  const AlarmScore score = Score();
  EXPECT_EQ(score.num_warned, 1);
  EXPECT_EQ(score.num_late, 1);
  EXPECT_EQ(score.most_key_frames, 2);
}

TEST_F(AlarmScoreTest, AnAlarmThatNothingHasMadeDueIsFalse) {
  Do(kPlaced, "shaft", "base.shaft");
  Say(alert_t::WARNING);
  Do(kTakenBack, "shaft", "base.shaft");
  Say(alert_t::WARNING);
  Say(alert_t::WARNING);
  const AlarmScore score = Score();
  EXPECT_EQ(score.num_warned, 1);
  EXPECT_EQ(score.num_false, 2);
  EXPECT_THAT(score.remarks,
              ElementsAre(HasSubstr("false"), HasSubstr("false")));
}

TEST(EmptySites, AllThatHasToWaitForAMissingPartStaysEmpty) {
  const ShippedTask task;
  const auto demonstrations = vtb::Demonstrations::FromConfig(
      ShippedDeployment().OfTask("demonstrators.yaml"), task.parts);
  const auto without = [&](const std::string& part) {
    return EmptySitesWithout({part}, demonstrations, task.parts);
  };
  EXPECT_THAT(EmptySitesWithout({}, demonstrations, task.parts), IsEmpty());
  using Sites = std::map<std::string, int>;
  EXPECT_EQ(without("face_plate"), (Sites{{"face_plate_seat", 1}}));
  EXPECT_EQ(without("shaft"), (Sites{{"face_plate_seat", 1},
                                     {"head_seat", 1},
                                     {"pendulum_seat", 1},
                                     {"shaft_hole", 1}}));
  EXPECT_EQ(without("square_peg_2"), (Sites{{"face_plate_seat", 1},
                                            {"separator_seat", 1},
                                            {"square_hole", 1}}));
}

}  // namespace
}  // namespace cell
