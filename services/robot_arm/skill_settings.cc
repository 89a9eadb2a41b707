#include "services/robot_arm/skill_settings.h"

#include <numbers>
#include <set>

#include "services/robot_arm/contact/contact_settings.h"

namespace cell::robot_arm {
namespace {

constexpr double kMm = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;

SkillSettings::Motion MotionFromConfig(const Config& config) {
  return {
      .transit_speed = kDegree * config.Number("transit_speed_deg_s", 1, 180),
      .transit_acceleration =
          kDegree * config.Number("transit_acceleration_deg_s2", 1, 2000),
      .line_speed = kMm * config.Number("line_speed_mm_s", 1, 1000),
      .clearance = kMm * config.Number("clearance_mm", 0, 100),
      .approach = kMm * config.Number("approach_mm", 10, 300),
      .raise = kMm * config.Number("raise_mm", 1, 300),
  };
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
  settings.motion = MotionFromConfig(config["motion"]);
  const Config fingers = config["fingers"];
  settings.fingers = {kMm * fingers.Number("open_margin_mm", 1, 50),
                      kMm * fingers.Number("close_beyond_mm", 1, 50)};
  const Config insertion = config["insertion"];
  const InsertionParams common =
      Refined(InsertionParams{}, insertion["default"]);
  const std::set<std::string> types = SiteTypes(parts);
  for (const std::string& type : types) settings.insertions[type] = common;
  for (const auto& [type, entry] : insertion.Entries()) {
    if (type == "default") continue;
    if (!types.contains(type)) entry.Fail("no site is of this type");
    settings.insertions[type] = Refined(common, entry);
  }
  settings.screwing = ScrewingFromConfig(config["screwing"]);
  if (config.Has("force_sensor")) {
    settings.force_sensor = ForceSensorFromConfig(config["force_sensor"]);
  }
  config.Finish();
  return settings;
}

}  // namespace cell::robot_arm
