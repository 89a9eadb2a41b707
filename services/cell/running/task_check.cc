#include "services/cell/running/task_check.h"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "common/bus/sim_bus.h"
#include "common/task/task.h"
#include "common/text/nearest.h"
#include "services/cell/running/pose_noise_check.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/scoring/success_criterion.h"
#include "services/robot_arm/skill_settings.h"
#include "services/robot_arm/skills/skill_catalog.h"
#include "services/vtb/script.h"

namespace cell::cli {

using namespace robot_arm;
using namespace vtb;
namespace {

using Names = std::vector<std::string>;

void CheckDemonstrators(const Config& config,
                        const Demonstrations& demonstrations,
                        const Domain& domain, const CellLayout& layout) {
  if (domain.FindGoal(demonstrations.goal) == nullptr) {
    config["goal"].Fail("domain.yaml has no goal '" + demonstrations.goal +
                        "'" +
                        NamesInstead(demonstrations.goal,
                                     NamesIn(domain.goals(), &Goal::name)));
  }
  for (const auto& [name, script] : demonstrations.scripts) {
    const Config entry = config["scripts"][name];
    if (script.num_hands > static_cast<int>(layout.hands.size())) {
      entry["hands"].Fail(fmt::format("cell.yaml has {} hands of a person",
                                      layout.hands.size()));
    }
    if (script.disturbance && layout.hands.empty()) {
      entry["disturbance"].Fail("cell.yaml has no hand of a person");
    }
  }
}

void CheckRoster(const Config& config, const CellFiles& files) {
  const auto known = AllServices(files.deployment, "", 1);
  for (const Config& item : config["services"].Items()) {
    const auto name = item.Get<std::string>("name");
    if (known.contains(name)) continue;
    item["name"].Fail("there is no service '" + name + "'" +
                      NamesInstead(name, KeysOf(known)));
  }
}

void CheckDemonstration(const Demonstrations& demonstrations,
                        const std::string& demonstration) {
  std::istringstream names(demonstration);
  for (std::string name; std::getline(names, name, '+');) {
    if (demonstrations.scripts.contains(name)) continue;
    throw std::invalid_argument(
        fmt::format("--demonstration {}: no script of demonstrators.yaml is "
                    "named '{}'{}",
                    demonstration, name,
                    NamesInstead(name, KeysOf(demonstrations.scripts))));
  }
}

void CheckHelpSteps(const Domain& domain, const Names& steps) {
  std::set<std::string> known;
  for (const GroundAction& action : domain.GroundActions(Agent::kRobot)) {
    known.insert(domain.actions()[action.action].name);
  }
  for (const std::string& step : steps) {
    if (known.contains(step)) continue;
    throw std::invalid_argument(
        fmt::format("--help-steps {}: the robot has no action '{}'; it has: {}",
                    step, step, fmt::join(known, ", ")));
  }
}

/// For each action of the robot an arm must have a skill.
void CheckSkills(const Config& config, const Task& task) {
  const auto& objects = task.domain.vocabulary().objects();
  for (const GroundAction& action : task.domain.GroundActions(Agent::kRobot)) {
    const auto skill = task.domain.SkillOf(action);
    if (!skill) continue;
    SkillRequest request{0, skill->name, {}};
    for (const auto& [name, object] : skill->arguments) {
      request.arguments[name] = objects[object].name;
    }
    const ArmLayout& arm = *task.layout.FindArm(objects[skill->arm].name);
    const auto why = WhyNoSkill(request, arm.X_FS.has_value());
    if (!why) continue;
    const std::string& name = task.domain.actions()[action.action].name;
    config["actions"][name]["skill"].Fail("the arm '" + arm.name +
                                          "': " + *why);
  }
}

}  // namespace

void CheckTask(const CellFiles& files, const RunRequest& request) {
  const Deployment& deployment = files.deployment;
  const Task task = LoadTask(deployment);
  SkillSettings::FromConfig(deployment.OfTask("skills.yaml"), task.parts);
  const Config demonstrations_config = deployment.OfTask("demonstrators.yaml");
  const auto demonstrations =
      Demonstrations::FromConfig(demonstrations_config, task.parts);
  SuccessCriterion::FromConfig(deployment.OfTask("success.yaml"), task.domain,
                               task.parts);

  CheckDemonstrators(demonstrations_config, demonstrations, task.domain,
                     task.layout);
  CheckDemonstration(demonstrations, request.demonstration);
  CheckHelpSteps(task.domain, request.help_steps);
  CheckSkills(deployment.OfTask("domain.yaml"), task);
  CheckPoseNoise(deployment);
  const Config roster = deployment.ForService("roster");
  CheckRoster(roster, files);
  const SimBus all(
      Roster::FromConfig(roster, request.has_cameras ? "cameras" : ""),
      AllServices(deployment, request.demonstration, 1));
}

}  // namespace cell::cli
