#include "common/task/task.h"

#include "common/task/task_consistency.h"

namespace cell {
namespace {

std::vector<ActionModel> ReadActions(const Config& domain_config,
                                     const Domain& domain,
                                     const PartTable& parts) {
  std::vector<ActionModel> models;
  for (const Action& action : domain.actions()) {
    ActionModel& model = models.emplace_back();
    model.action = action;
    const Config config = domain_config["actions"][action.name];
    if (config.Has("sec")) {
      model.sec = SecConditions::FromConfig(config["sec"], action.arguments,
                                            domain.vocabulary(), parts);
    }
    if (action.skill) model.skill_settings = SettingsOf(*action.skill);
  }
  return models;
}

}  // namespace

std::shared_ptr<const PredicateSensor> Task::MakeSensor() const {
  return std::make_shared<const PredicateSensor>(domain.vocabulary(), parts,
                                                 layout.workspace, geometries);
}

Task LoadTask(const Deployment& deployment) {
  const Config parts_config = deployment.OfTask("parts.yaml");
  const Config domain_config = deployment.OfTask("domain.yaml");
  const PartTable parts = PartTable::FromConfig(parts_config);
  const CellLayout layout =
      CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  const Domain domain = Domain::FromConfig(domain_config, parts);
  Task task{parts,
            layout,
            SceneObjects(parts, layout),
            domain,
            ReadGeometries(domain_config, domain.vocabulary(), parts),
            ReadActions(domain_config, domain, parts)};
  domain_config.Finish();
  CheckGrasps(parts_config, parts, layout);
  CheckActions(domain_config, domain, parts, layout);
  CheckReports(domain_config, domain, layout);
  return task;
}

}  // namespace cell
