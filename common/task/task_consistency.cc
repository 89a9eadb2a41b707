#include "common/task/task_consistency.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "common/task/learned_rules.h"

namespace cell {
namespace {

const char* NameOf(Agent agent) {
  return agent == Agent::kPerson ? "person" : "robot";
}

bool HasHandFor(const Grasp& grasp, const std::string& grip,
                const CellLayout& layout) {
  const auto hands = layout.AllHands();
  return std::any_of(hands.begin(), hands.end(), [&](const auto& hand) {
    return hand.type->FindGrip(grip) != nullptr &&
           grasp.width <= hand.type->max_opening;
  });
}

/// Rejects an insertion that no arm can do, or of a part that does not fit.
void CheckSkill(const Config& config, const GroundSkill& skill,
                const Domain& domain, const PartTable& parts,
                const CellLayout& layout) {
  const auto& objects = domain.vocabulary().objects();
  const std::string& arm = objects[skill.arm].name;
  if (layout.FindArm(arm) == nullptr) {
    config["arm"].Fail("cell.yaml has no arm '" + arm + "'");
  }
  const auto name_of = [&](const char* argument) -> std::string {
    const auto it = skill.arguments.find(argument);
    return it == skill.arguments.end() ? "" : objects[it->second].name;
  };
  const std::string part_name = name_of("part"), site_name = name_of("site");
  const Part* part = parts.Find(part_name);
  if (!part_name.empty() && part == nullptr) {
    config["part"].Fail("parts.yaml has no part '" + part_name + "'");
  }
  const Site* site = parts.FindSite(site_name);
  if (!site_name.empty() && site == nullptr) {
    config["site"].Fail("parts.yaml has no site '" + site_name + "'");
  }
  if (part == nullptr || site == nullptr) return;
  if (std::count(part->fits.begin(), part->fits.end(), site->type) == 0) {
    config["site"].Fail(fmt::format("{} does not fit {}, a {}", part_name,
                                    site->name, site->type));
  }
}

}  // namespace

void CheckGrasps(const Config& config, const PartTable& parts,
                 const CellLayout& layout) {
  for (const Part& part : parts.parts()) {
    const Config entry = config["parts"][part.name];
    const std::vector<Config> entries =
        part.joint ? std::vector{entry["handle"]} : entry.ItemsOf("grasps");
    for (size_t i = 0; i < part.grasps.size(); ++i) {
      for (const std::string& grip : part.grasps[i].grips) {
        if (HasHandFor(part.grasps[i], grip, layout)) continue;
        entries[i].Fail(
            fmt::format("no hand of cell.yaml has the grip '{}' "
                        "and opens {} mm",
                        grip, 1e3 * part.grasps[i].width));
      }
    }
  }
}

void CheckActions(const Config& config, const Domain& domain,
                  const PartTable& parts, const CellLayout& layout) {
  std::set<std::pair<int, Agent>> possible;
  for (const Agent agent : {Agent::kPerson, Agent::kRobot}) {
    for (const GroundAction& action : domain.GroundActions(agent)) {
      possible.insert({action.action, agent});
      const auto skill = domain.SkillOf(action);
      if (agent != Agent::kRobot || !skill) continue;
      const std::string& name = domain.actions()[action.action].name;
      CheckSkill(config["actions"][name]["skill"], *skill, domain, parts,
                 layout);
    }
  }
  for (size_t i = 0; i < domain.actions().size(); ++i) {
    const Action& action = domain.actions()[i];
    if (action.rules.empty() && config.Has(kLearnedRulesKey)) continue;
    for (const Agent agent : action.agents) {
      if (possible.contains({static_cast<int>(i), agent})) continue;
      config["actions"][action.name].Fail(fmt::format(
          "there are no objects with which the {} could do it", NameOf(agent)));
    }
  }
}

void CheckReports(const Config& config, const Domain& domain,
                  const CellLayout& layout) {
  const Vocabulary& vocabulary = domain.vocabulary();
  for (const Predicate& predicate : vocabulary.predicates()) {
    if (!predicate.report) continue;
    const size_t of_arm = *predicate.report == Predicate::Report::kHeld ? 1 : 0;
    if (predicate.argument_types.size() <= of_arm) continue;
    for (const int arm :
         vocabulary.ObjectsOf(predicate.argument_types[of_arm])) {
      const std::string& name = vocabulary.objects()[arm].name;
      if (layout.FindArm(name) != nullptr) continue;
      config["predicates"][predicate.name]["arguments"].Fail(
          fmt::format("'{}' is not an arm of cell.yaml", name));
    }
  }
}

}  // namespace cell
