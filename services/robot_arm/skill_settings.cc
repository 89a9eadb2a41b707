#include "services/robot_arm/skill_settings.h"

#include <set>

#include "services/robot_arm/contact/contact_settings.h"

namespace cell::robot_arm {
namespace {

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
  settings.distances = SafetyDistances::FromConfig(config["distances"]);
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
