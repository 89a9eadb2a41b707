#include "services/vtb/script.h"

#include <algorithm>
#include <set>

#include "common/text/nearest.h"

namespace cell::vtb {
namespace {

constexpr double kMm = 1e-3;

std::vector<std::string> NamesOf(const Config& config, const std::string& key) {
  std::vector<std::string> names;
  for (const Config& item : config.ItemsOf(key)) {
    names.push_back(item.As<std::string>());
    if (std::ranges::count(names, names.back()) > 1) {
      item.Fail("'" + names.back() + "' is named twice");
    }
  }
  return names;
}

CountRange CountOf(const Config& config) {
  const auto range = config.Get<std::vector<int>>("count");
  if (range.size() != 2 || range[0] < 0 || range[1] < range[0]) {
    config["count"].Fail("should be [low, high]");
  }
  const CountRange count{range[0], range[1]};
  return count;
}

HumanMotionParams HumanMotionFromConfig(const Config& config) {
  HumanMotionParams human_motion;
  human_motion.speeds = {config.Number("across", 0.05, 2),
                         config.Number("along", 0.05, 2),
                         config.Number("turning", 0.1, 10)};
  human_motion.speed_spread = config.Number("speed_spread", 0, 0.9);
  human_motion.bend = config.Number("bend", 0, 0.2);
  human_motion.first_pause = config.Number("first_pause", 0, 60);
  const std::vector<double> pause = config.Numbers("pause", 2);
  if (!(pause[0] >= 0 && pause[1] >= pause[0])) {
    config["pause"].Fail("should be [low, high]");
  }
  human_motion.pause_low = pause[0];
  human_motion.pause_high = pause[1];
  human_motion.dwell = config.Number("dwell", 0, 10);
  human_motion.close_time = config.Number("close_time", 0.05, 10);
  human_motion.open_margin = config.Number("open_margin", 0.001, 0.1);
  human_motion.insert_speed = config.Number("insert_speed", 0.005, 1);
  human_motion.aim_error = config.Number("aim_error", 0, 0.01);
  human_motion.turn_rate = config.Number("turn_rate", 0.1, 10);
  human_motion.clearance = config.Number("clearance", 0.01, 0.5);
  human_motion.table_gap = config.Number("table_gap", 0, 0.5);
  human_motion.hands_gap = config.Number("hands_gap", 0, 2);
  return human_motion;
}

template <class Items, class Proj>
bool AnyIs(const Items& items, const std::string& value, Proj proj) {
  return std::ranges::find(items, value, proj) != items.end();
}

PlacementRule RuleFromConfig(const Config& config, const std::string& name,
                             const PartTable& table) {
  PlacementRule rule;
  rule.name = name;
  rule.called = config.GetOr<std::string>("called", "");
  rule.makes = config.GetOr<std::string>("makes", "");
  rule.part_type = config.Get<std::string>("part");
  rule.site_type = config.Get<std::string>("site");
  if (!AnyIs(table.parts(), rule.part_type, &Part::type)) {
    config["part"].Fail("no part is of type '" + rule.part_type + "'");
  }
  if (std::ranges::none_of(table.parts(), [&](const Part& part) {
        return AnyIs(part.sites, rule.site_type, &Site::type);
      })) {
    config["site"].Fail("no site is of type '" + rule.site_type + "'");
  }
  if (std::ranges::none_of(table.parts(), [&](const Part& part) {
        return part.type == rule.part_type &&
               AnyIs(part.fits, rule.site_type, std::identity{});
      })) {
    config["site"].Fail("no part of the type '" + rule.part_type + "' fits '" +
                        rule.site_type + "', as parts.yaml says");
  }
  rule.after = NamesOf(config, "after");
  if (config.Has("aim_mm")) {
    const std::vector<double> aim = config.Numbers("aim_mm", 3);
    rule.aim = kMm * Eigen::Vector3d(aim[0], aim[1], aim[2]);
  }
  rule.press = kMm * config.Number("press_mm", 0, 50);
  rule.seated = SeatTolerance::FromConfig(config["seated"]);
  return rule;
}

Script::Disturbance DisturbanceFromConfig(const Config& config) {
  using Kind = Script::Disturbance::Kind;
  Script::Disturbance disturbance;
  disturbance.helps = config.GetOr("helps", false);
  if (!config.Has("disturbs")) return disturbance;
  const Config disturbs = config["disturbs"];
  const auto how = disturbs.Get<std::string>("how");
  if (how == "move") {
    disturbance.kind = Kind::kMove;
  } else if (how == "return") {
    disturbance.kind = Kind::kReturn;
  } else if (how == "place") {
    disturbance.kind = Kind::kPlace;
  } else {
    disturbs["how"].Fail("'" + how + "' is not one of move, return, place");
  }
  disturbance.beyond_reach = disturbs.GetOr<bool>("beyond_reach", false);
  disturbance.count = CountOf(disturbs);
  const std::vector<double> within = disturbs.Numbers("within_s", 2);
  if (!(within[0] >= 0 && within[1] >= within[0])) {
    disturbs["within_s"].Fail("should be [low, high]");
  }
  disturbance.earliest = within[0];
  disturbance.latest = within[1];
  disturbance.part_types = NamesOf(disturbs, "of");
  for (const Config& place : disturbs.ItemsOf("to")) {
    const auto xy = place.As<std::vector<double>>();
    if (xy.size() != 2) place.Fail("should be [x, y]");
    disturbance.places.emplace_back(xy[0], xy[1]);
  }
  return disturbance;
}

Script::Start StartFromConfig(const Config& config) {
  Script::Start start{config.GetOr<std::string>("site", "")};
  const bool is_lying = config.GetOr("lying", false);
  if (is_lying == start.site.empty()) return start;
  config.Fail("should be either {lying: true} or {site: NAME}");
}

Script ScriptFromConfig(const Config& config, const std::string& name) {
  Script script;
  script.name = name;
  script.agent = config.GetOr<std::string>("agent", script.agent);
  if (script.agent != "person" && script.agent != "robot") {
    config["agent"].Fail("'" + script.agent + "' is neither person nor robot");
  }
  if (config.Has("max_duration_s")) {
    script.max_duration = config.Number("max_duration_s", 1, 86400);
  }
  script.num_hands = config.Integer("hands", 0, 2);
  script.place = NamesOf(config, "place");
  if (script.agent == "person" && script.num_hands == 0) {
    config["hands"].Fail("a person needs a hand");
  }
  if (config.Has("take_backs")) {
    const Config take_backs = config["take_backs"];
    script.take_backs = CountOf(take_backs);
    script.take_back_of = NamesOf(take_backs, "of");
  }
  if (config.Has("unknown_moves")) {
    script.unknown_moves = CountOf(config["unknown_moves"]);
  }
  if (config.Has("attempts")) {
    script.attempts = CountOf(config["attempts"]);
  }
  if (config.Has("too_early")) {
    script.too_early = config.Get<std::string>("too_early");
  }
  if (config.Has("start")) {
    for (const auto& [part, entry] : config["start"].Entries()) {
      script.start.emplace(part, StartFromConfig(entry));
    }
  }
  script.lay_outside = NamesOf(config, "lay_outside");
  script.lay_down = NamesOf(config, "lay_down");
  if (config.Has("disturbance")) {
    script.disturbance = DisturbanceFromConfig(config["disturbance"]);
  }
  return script;
}

/// Refuses rules that are unknown or wait for themselves.
void CheckAfter(const Config& config, const Demonstrations& demonstrations) {
  const auto key = [&](const std::string& name) {
    return config["placements"][name]["after"];
  };
  for (const auto& [name, rule] : demonstrations.rules) {
    for (const std::string& before : rule.after) {
      if (!demonstrations.rules.contains(before)) {
        key(name).Fail("no placement '" + before + "'");
      }
    }
  }
  for (const auto& [name, rule] : demonstrations.rules) {
    std::set<std::string> before;
    std::vector<std::string> to_visit = rule.after;
    while (!to_visit.empty()) {
      const std::string next = to_visit.back();
      to_visit.pop_back();
      if (next == name) key(name).Fail("waits for itself");
      if (!before.insert(next).second) continue;
      const auto& after = demonstrations.rules.at(next).after;
      to_visit.insert(to_visit.end(), after.begin(), after.end());
    }
  }
}

/// Of what starts at sites: that it fits, and that nothing else is there.
void CheckStart(const Config& config, const Script& script,
                const PartTable& table) {
  std::set<std::string> taken;
  for (const auto& [name, start] : script.start) {
    const Config entry = config["start"][name];
    const Part* part = table.Find(name);
    if (part == nullptr) {
      entry.Fail("no part is named '" + name + "'" +
                 NamesInstead(name, NamesIn(table.parts(), &Part::name)));
    }
    if (!part->is_free()) entry.Fail("'" + name + "' cannot be moved");
    if (start.site.empty()) continue;
    const Site* site = table.FindSite(start.site);
    if (site == nullptr) {
      entry["site"].Fail("no part has a site '" + start.site + "'");
    }
    if (!AnyIs(part->fits, site->type, std::identity{})) {
      entry["site"].Fail("'" + name + "' does not fit '" + site->name +
                         "', as parts.yaml says");
    }
    if (table.Find(site->host)->is_free()) {
      entry["site"].Fail("'" + site->host + "' lies anywhere at the start");
    }
    if (!taken.insert(site->name).second) {
      entry["site"].Fail("another part starts at '" + site->name + "'");
    }
  }
}

void CheckTypes(const Config& config, const char* key,
                const std::vector<std::string>& types, const PartTable& table) {
  for (const std::string& type : types) {
    if (AnyIs(table.parts(), type, &Part::type)) continue;
    config[key].Fail("no part is of type '" + type + "'");
  }
}

void CheckScript(const Config& config, const Script& script,
                 const Demonstrations& demonstrations, const PartTable& table) {
  CheckStart(config, script, table);
  CheckTypes(config, "lay_outside", script.lay_outside, table);
  CheckTypes(config, "lay_down", script.lay_down, table);
  if (script.disturbance && !script.disturbance->part_types.empty()) {
    CheckTypes(config["disturbance"]["disturbs"], "of",
               script.disturbance->part_types, table);
  }
  const auto check = [&](const std::string& key, const std::string& rule) {
    if (!demonstrations.rules.contains(rule)) {
      config[key].Fail("no placement '" + rule + "'");
    }
  };
  for (const std::string& rule : script.place) {
    check("place", rule);
    for (const std::string& before : demonstrations.rules.at(rule).after) {
      if (!AnyIs(script.place, before, std::identity{})) {
        config["place"].Fail("'" + rule + "' needs '" + before + "'");
      }
    }
  }
  for (const std::string& rule : script.take_back_of) check("take_backs", rule);
  if (script.too_early) check("too_early", *script.too_early);
}

std::vector<std::string> ScriptsFromConfig(
    const Config& config, const Demonstrations& demonstrations) {
  std::vector<std::string> names;
  for (const Config& item : config.Items()) {
    names.push_back(item.As<std::string>());
    if (!demonstrations.scripts.contains(names.back())) {
      item.Fail("no script is named '" + names.back() + "'" +
                NamesInstead(names.back(), KeysOf(demonstrations.scripts)));
    }
  }
  if (names.empty()) config.Fail("names no script");
  return names;
}

std::map<std::string, std::vector<std::string>> WatchedFromConfig(
    const Config& config, const Demonstrations& demonstrations) {
  std::map<std::string, std::vector<std::string>> watched;
  for (const char* kind : {"correct", "deviation", "dead_end"}) {
    watched[kind] = ScriptsFromConfig(config[kind], demonstrations);
  }
  return watched;
}

std::vector<std::string> TeachingFromConfig(
    const Config& config, const Demonstrations& demonstrations) {
  std::vector<std::string> teaching;
  for (const auto& [name, entry] : config.Entries()) {
    if (!demonstrations.scripts.contains(name)) {
      entry.Fail("no script '" + name + "'");
    }
    constexpr int kMost = 100;
    teaching.insert(teaching.end(),
                    static_cast<size_t>(config.Integer(name, 1, kMost)), name);
  }
  return teaching;
}

}  // namespace

Demonstrations Demonstrations::FromConfig(const Config& config,
                                          const PartTable& table) {
  Demonstrations demonstrations;
  demonstrations.goal = config.Get<std::string>("goal");
  demonstrations.human_motion = HumanMotionFromConfig(config["human_motion"]);
  demonstrations.raising = config.GetOr<std::string>("raising", "");
  demonstrations.lies = config.GetOr<std::string>("lies", "");
  for (const auto& [name, entry] : config["placements"].Entries()) {
    demonstrations.rules.emplace(name, RuleFromConfig(entry, name, table));
  }
  CheckAfter(config, demonstrations);
  for (const auto& [name, entry] : config["scripts"].Entries()) {
    const Script script = ScriptFromConfig(entry, name);
    CheckScript(entry, script, demonstrations, table);
    demonstrations.scripts.emplace(name, script);
  }
  demonstrations.default_episodes =
      ScriptsFromConfig(config["default"], demonstrations);
  if (config.Has("teaching")) {
    demonstrations.teaching =
        TeachingFromConfig(config["teaching"], demonstrations);
  }
  if (config.Has("watched")) {
    demonstrations.watched =
        WatchedFromConfig(config["watched"], demonstrations);
  }
  config.Finish();
  return demonstrations;
}

}  // namespace cell::vtb
