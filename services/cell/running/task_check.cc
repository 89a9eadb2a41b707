#include "services/cell/running/task_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/bus/sim_bus.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"
#include "common/sec/gallery.h"
#include "services/cell/evaluations/success_criterion.h"
#include "services/cell/running/service_registry.h"
#include "services/robot_arm/skill_settings.h"
#include "services/vtb/script.h"

namespace cell::cli {

using namespace robot_arm;
using namespace vtb;
namespace {

using Names = std::vector<std::string>;

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

/// An insertion that no arm can do, or whose part fits no such site.
void CheckSkill(const Config& config, const GroundSkill& skill,
                const Domain& domain, const PartTable& parts,
                const CellLayout& layout) {
  const auto& objects = domain.vocabulary().objects();
  const std::string& arm = objects[skill.arm].name;
  if (layout.FindArm(arm) == nullptr) {
    config["arm"].Fail("cell.yaml has no arm '" + arm + "'");
  }
  const std::string& name = objects[skill.part].name;
  const Part* part = parts.Find(name);
  if (part == nullptr) {
    config["part"].Fail("parts.yaml has no part '" + name + "'");
  }
  if (!skill.site) return;
  const Site* site = parts.FindSite(objects[*skill.site].name);
  if (site == nullptr) {
    config["site"].Fail("parts.yaml has no site '" + objects[*skill.site].name +
                        "'");
  }
  if (std::count(part->fits.begin(), part->fits.end(), site->type) == 0) {
    config["site"].Fail(
        fmt::format("{} does not fit {}, a {}", name, site->name, site->type));
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
    for (const Agent agent : action.agents) {
      if (possible.contains({static_cast<int>(i), agent})) continue;
      config["actions"][action.name].Fail(fmt::format(
          "there are no objects that the {} could do it with", NameOf(agent)));
    }
  }
}

/// What an arm says of itself is said by the arms that there are.
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
          fmt::format("'{}' is no arm of cell.yaml", name));
    }
  }
}

Names GoalNames(const Domain& domain) {
  Names names;
  for (const Goal& goal : domain.goals()) names.push_back(goal.name);
  return names;
}

void CheckDemonstrators(const Config& config, const DemonstratorBook& book,
                        const Domain& domain, const CellLayout& layout) {
  if (domain.FindGoal(book.goal) == nullptr) {
    config["goal"].Fail(fmt::format("domain.yaml has no goal '{}', but: {}",
                                    book.goal,
                                    fmt::join(GoalNames(domain), ", ")));
  }
  for (const auto& [name, script] : book.scripts) {
    const Config entry = config["scripts"][name];
    if (script.num_hands > static_cast<int>(layout.hands.size())) {
      entry["hands"].Fail(fmt::format("cell.yaml has {} hands of persons",
                                      layout.hands.size()));
    }
    if (script.bystander && layout.hands.empty()) {
      entry["bystander"].Fail("cell.yaml has no hand of a person");
    }
  }
}

void CheckRoster(const Config& config, const CellFiles& files) {
  const auto known = AllServices(files.deployment, "", 1);
  for (const Config& item : config["services"].Items()) {
    const auto name = item.Get<std::string>("name");
    if (known.contains(name)) continue;
    Names names;
    for (const auto& [service, factory] : known) names.push_back(service);
    item["name"].Fail(fmt::format("there is no service '{}', but: {}", name,
                                  fmt::join(names, ", ")));
  }
}

void CheckDemonstration(const DemonstratorBook& book,
                        const std::string& demonstration) {
  std::istringstream names(demonstration);
  for (std::string name; std::getline(names, name, '+');) {
    if (book.scripts.contains(name)) continue;
    Names known;
    for (const auto& [script, entry] : book.scripts) known.push_back(script);
    throw std::invalid_argument(
        fmt::format("--demonstration {}: no script of demonstrators.yaml is "
                    "named '{}', but: {}",
                    demonstration, name, fmt::join(known, ", ")));
  }
}

}  // namespace

void CheckTask(const CellFiles& files, const std::string& demonstration) {
  const Deployment& deployment = files.deployment;
  const Config parts_config = deployment.OfTask("parts.yaml");
  const PartTable parts = PartTable::FromConfig(parts_config);
  const CellLayout layout =
      CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  const Config domain_config = deployment.OfTask("domain.yaml");
  const Domain domain = Domain::FromConfig(domain_config, parts);
  const Gallery gallery(domain, parts);
  SkillSettings::FromConfig(deployment.OfTask("skills.yaml"), parts);
  const Config book_config = deployment.OfTask("demonstrators.yaml");
  const auto book = DemonstratorBook::FromConfig(book_config, parts);
  SuccessCriterion::FromConfig(deployment.OfTask("success.yaml"), domain,
                               parts);

  CheckGrasps(parts_config, parts, layout);
  CheckActions(domain_config, domain, parts, layout);
  CheckReports(domain_config, domain, layout);
  CheckDemonstrators(book_config, book, domain, layout);
  CheckDemonstration(book, demonstration);
  CheckRoster(deployment.ForService("roster"), files);
  const SimBus all(files.roster, AllServices(deployment, demonstration, 1));
}

}  // namespace cell::cli
