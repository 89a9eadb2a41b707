#include "services/robot_arm/skill_settings.h"

#include <numbers>
#include <set>
#include <vector>

namespace cell::robot_arm {
namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;

// Stability at 125 Hz with a stiff contact was found up to these.
constexpr double kMaxKp = 3e-5, kMaxKi = 1e-3;
constexpr double kMaxTurnKp = 4e-3, kMaxTurnKi = 0.15;

/// Reads what `config` says on top of what `seating` has.
SkillSettings::Seating Refined(SkillSettings::Seating seating,
                               const Config& config) {
  Insertion::Params& p = seating.insertion;
  const auto read = [&](const char* key, double unit, double low, double high,
                        double* value) {
    if (config.Has(key)) *value = unit * config.Number(key, low, high);
  };
  read("push", 1, 1, 60, &p.push);
  read("kp", 1, 0, kMaxKp, &p.kp);
  read("ki", 1, 1e-6, kMaxKi, &p.ki);
  read("kp_turn", 1, 0, kMaxTurnKp, &p.kp_turn);
  read("ki_turn", 1, 0, kMaxTurnKi, &p.ki_turn);
  read("feed_mm_s", kMm, 1, 200, &p.feed);
  read("touch_feed_mm_s", kMm, 1, 50, &p.touch_feed);
  read("touch_mm", kMm, 0, 300, &p.touch_height);
  read("spiral_pitch_mm", kMm, 0.1, 10, &p.spiral_pitch);
  read("spiral_speed_mm_s", kMm, 1, 50, &p.spiral_speed);
  read("spiral_radius_mm", kMm, 0, 20, &p.spiral_radius);
  read("yaw_dither_deg", kDegree, 0, 5, &p.yaw_dither);
  read("tilt_dither_deg", kDegree, 0, 5, &p.tilt_dither);
  read("end_mm", kMm, 0, 100, &p.end_height);
  read("tolerance_mm", kMm, 0.01, 10, &p.tolerance);
  read("give_mm", kMm, 0, 10, &p.give);
  read("timeout_s", 1, 1, 600, &p.timeout);
  if (config.Has("aim_mm")) {
    const std::vector<double> aim = config.Numbers("aim_mm", 2);
    seating.aim = kMm * Eigen::Vector2d(aim[0], aim[1]);
  }
  return seating;
}

std::set<std::string> SiteTypes(const PartTable& parts) {
  std::set<std::string> types;
  for (const Part& part : parts.parts()) {
    for (const Site& site : part.sites) types.insert(site.type);
  }
  return types;
}

}  // namespace

SkillSettings SkillSettings::FromConfig(const Config& config,
                                        const PartTable& parts) {
  SkillSettings settings;
  settings.motion = MotionSettings::FromConfig(config["motion"]);
  settings.fingers = FingerSettings::FromConfig(config["fingers"]);
  const Config insertion = config["insertion"];
  const Seating common = Refined({}, insertion["default"]);
  const std::set<std::string> types = SiteTypes(parts);
  for (const std::string& type : types) settings.seatings[type] = common;
  for (const auto& [type, entry] : insertion.Entries()) {
    if (type == "default") continue;
    if (!types.contains(type)) entry.Fail("no site is of this type");
    settings.seatings[type] = Refined(common, entry);
  }
  const Config turning = config["turning"];
  Turning::Params& t = settings.turning;
  t.rate = kDegree * turning.Number("rate_deg_s", 1, 360);
  t.push = turning.Number("push", 0, 50);
  t.max_torque = turning.Number("max_torque", 0.01, 20);
  t.min_angle = kDegree * turning.Number("min_angle_deg", 0, 720);
  t.max_angle = kDegree * turning.Number("max_angle_deg", 0, 720);
  if (t.min_angle > t.max_angle) {
    turning["min_angle_deg"].Fail("lies above max_angle_deg");
  }
  config.Finish();
  return settings;
}

}  // namespace cell::robot_arm
