// How skills.yaml is read: optional keys, and what is refused.
#include "services/robot_arm/skill_settings.h"

#include <gmock/gmock.h>

#include <numbers>
#include <string>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using testing::HasSubstr;

constexpr char kFew[] = R"(
motion: {transit_speed_deg_s: 57, transit_acceleration_deg_s2: 143,
  line_speed_mm_s: 120, clearance_mm: 8, approach_mm: 100, raise_mm: 100}
fingers: {open_margin_mm: 14, close_beyond_mm: 6}
distances: {hands_mm: 250, hands_at_work_mm: 100, hands_too_near_mm: 50,
  in_hand_mm: 15, standing_arm_mm: 6, moving_arm_mm: 60, patience_s: 15}
insertion:
  default: {}
screwing:
  thread: {push_n: 1, rate_deg_s: 75}
  tight: {torque_nm: 0.4, min_angle_deg: 250, max_angle_deg: 480}
)";

class SkillSettingsTest : public testing::Test {
 protected:
  SkillSettings Read(const std::string& text) const {
    return SkillSettings::FromConfig(Config::Parse(text, "skills.yaml"),
                                     parts_);
  }
  /// What is said of kFew with the one text in place of the other.
  std::string ErrorOf(const std::string& from, const std::string& to) const {
    std::string text = kFew;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
      Read(text);
    } catch (const ConfigError& e) {
      return e.what();
    }
    return "no error";
  }
  /// The same of what insertions have in common.
  std::string ErrorOfDefault(const std::string& section) const {
    return ErrorOf("default: {}", "default: {" + section + "}");
  }

  const PartTable parts_ =
      PartTable::FromConfig(ShippedDeployment().OfTask("parts.yaml"));
};

TEST_F(SkillSettingsTest, DistancesToPeopleAreRefusedWhereTheyMakeNoSense) {
  EXPECT_THAT(ErrorOf("hands_too_near_mm: 50", "hands_too_near_mm: 120"),
              HasSubstr("skills.yaml:distances.hands_too_near_mm: lies above"));
  EXPECT_THAT(ErrorOf("hands_mm: 250, ", ""),
              HasSubstr("skills.yaml:distances.hands_mm: missing"));
}

TEST_F(SkillSettingsTest, TheShippedTaskIsReadable) {
  const SkillSettings settings = SkillSettings::FromConfig(
      ShippedDeployment().OfTask("skills.yaml"), parts_);
  EXPECT_DOUBLE_EQ(settings.insertions.at("face_plate_seat").feed.push, 20);
  EXPECT_EQ(settings.screwing.contact.admittance.kp_turn, 0);
  EXPECT_DOUBLE_EQ(settings.insertions.at("pendulum_seat").aim.y(), 0.001);
}

TEST_F(SkillSettingsTest, WhatATaskDoesNotNameIsAsTheCodeSays) {
  const SkillSettings settings = Read(kFew);
  const InsertionParams& params = settings.insertions.at("round_hole");
  EXPECT_EQ(params.feed.push, StraightFeed::Params().push);
  EXPECT_EQ(params.contact.search.max_spirals, 4);
  EXPECT_EQ(settings.force_sensor.patience, 0.05);
  EXPECT_EQ(settings.screwing.contact.admittance.ki_turn, 0);
  EXPECT_EQ(settings.screwing.contact.slow_down.gain, 0);
}

TEST_F(SkillSettingsTest, ATypeOfSiteNamesOnlyWhatDiffers) {
  std::string text = kFew;
  text.replace(text.find("default: {}"), 11,
               "default: {feed: {push_n: 12, touch_mm_s: 5}}\n"
               "  square_hole: {feed: {push_n: 9}, dither: {yaw_deg: 2}}");
  const SkillSettings settings = Read(text);
  const InsertionParams& square = settings.insertions.at("square_hole");
  EXPECT_EQ(square.feed.push, 9);
  EXPECT_DOUBLE_EQ(square.feed.touch_feed, 0.005);
  EXPECT_NEAR(square.contact.dither.yaw, std::numbers::pi / 90, 1e-12);
  EXPECT_EQ(settings.insertions.at("round_hole").feed.push, 12);
  EXPECT_EQ(settings.insertions.at("round_hole").contact.dither.yaw, 0);
}

TEST_F(SkillSettingsTest, EveryConstantOfAContactMotionCanBeNamed) {
  std::string text = kFew;
  text.replace(text.find("default: {}"), 11,
               "default: {feed: {touch_share: 0.4, loose_share: 0.2,"
               " loose_time_s: 0.3}, stall: {push_share: 0.5, move_mm: 0.4,"
               " time_s: 0.5}, search: {found_mm: 0.9, max_spirals: 7},"
               " dither: {yaw_period_s: 0.8, tilt_period_s: 1.1,"
               " rise_time_s: 0.2}, admittance: {max_drift_mm: 5,"
               " max_turn_rad: 0.2}, slow_down: {gain_per_n: 0.1, dead_n: 4},"
               " limits: {force_n: 70, time_s: 20}}");
  text += "force_sensor: {cutoff_hz: 20, patience_s: 0.1}\n";
  const SkillSettings settings = Read(text);
  const InsertionParams& params = settings.insertions.at("round_hole");
  EXPECT_EQ(params.feed.touch_share, 0.4);
  EXPECT_EQ(params.feed.loose_share, 0.2);
  EXPECT_EQ(params.feed.loose_time, 0.3);
  EXPECT_EQ(params.contact.stall.push_share, 0.5);
  EXPECT_DOUBLE_EQ(params.contact.stall.move, 0.0004);
  EXPECT_EQ(params.contact.stall.time, 0.5);
  EXPECT_DOUBLE_EQ(params.contact.search.found, 0.0009);
  EXPECT_EQ(params.contact.search.max_spirals, 7);
  EXPECT_EQ(params.contact.dither.yaw_period, 0.8);
  EXPECT_EQ(params.contact.dither.tilt_period, 1.1);
  EXPECT_EQ(params.contact.dither.rise_time, 0.2);
  EXPECT_DOUBLE_EQ(params.contact.admittance.max_drift, 0.005);
  EXPECT_EQ(params.contact.admittance.max_turn, 0.2);
  EXPECT_EQ(params.contact.slow_down.gain, 0.1);
  EXPECT_EQ(params.contact.slow_down.dead, 4);
  EXPECT_EQ(params.contact.limits.force, 70);
  EXPECT_EQ(params.contact.limits.time, 20);
  EXPECT_EQ(settings.force_sensor.cutoff, 20);
  EXPECT_EQ(settings.force_sensor.patience, 0.1);
}

TEST_F(SkillSettingsTest, NamesKeysThatNoPartHas) {
  EXPECT_THAT(ErrorOfDefault("feed: {push: 15}"),
              HasSubstr("skills.yaml:insertion.default.feed.push: not known"));
  EXPECT_THAT(ErrorOfDefault("push_n: 15"),
              HasSubstr("skills.yaml:insertion.default.push_n: not known"));
  EXPECT_THAT(ErrorOf("screwing:", "screwing:\n  search: {pitch_mm: 1}"),
              HasSubstr("skills.yaml:screwing.search: not known"));
}

TEST_F(SkillSettingsTest, NamesWhatLiesOutsideItsRange) {
  EXPECT_THAT(ErrorOfDefault("admittance: {kp_m_per_n: 4.0e-5}"),
              HasSubstr("skills.yaml:insertion.default.admittance.kp_m_per_n: "
                        "4e-05 lies outside [0, 3e-05]"));
  EXPECT_THAT(ErrorOfDefault("search: {max_spirals: -1}"),
              HasSubstr("skills.yaml:insertion.default.search.max_spirals: -1 "
                        "lies outside [0, 100]"));
  EXPECT_THAT(ErrorOf("torque_nm: 0.4", "torque_nm: 0"),
              HasSubstr("skills.yaml:screwing.tight.torque_nm: 0 lies outside "
                        "[0.01, 20]"));
}

TEST_F(SkillSettingsTest, NamesFiguresThatContradictEachOther) {
  EXPECT_THAT(ErrorOf("min_angle_deg: 250", "min_angle_deg: 500"),
              HasSubstr("skills.yaml:screwing.tight.min_angle_deg: must not "
                        "lie above max_angle_deg"));
  EXPECT_THAT(ErrorOfDefault("feed: {touch_share: 0.05}"),
              HasSubstr("skills.yaml:insertion.default.feed.touch_share: must "
                        "not lie below loose_share"));
  EXPECT_THAT(ErrorOfDefault("search: {pitch_mm: 8}"),
              HasSubstr("skills.yaml:insertion.default.search.pitch_mm: must "
                        "not lie above radius_mm"));
}

TEST_F(SkillSettingsTest, NamesWhatIsMissingAndTypesThatNoSiteHas) {
  EXPECT_THAT(ErrorOf("push_n: 1, ", ""),
              HasSubstr("skills.yaml:screwing.thread.push_n: missing"));
  EXPECT_THAT(ErrorOf("default: {}", "default: {}\n  oval_hole: {}"),
              HasSubstr("skills.yaml:insertion.oval_hole: no site is of this "
                        "type"));
}

}  // namespace
}  // namespace cell
