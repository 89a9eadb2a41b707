#include "common/task/task.h"

#include <set>
#include <string>

#include "common/actions/sec_models.h"
#include "common/task/learned_rules.h"
#include "common/task/task_actions.h"
#include "common/task/task_consistency.h"

namespace cell {
namespace {

std::vector<ActionModel> ReadActions(const Config& sec_config,
                                     const Domain& domain,
                                     const PartTable& parts) {
  std::vector<ActionModel> models;
  for (const Action& action : domain.actions()) {
    ActionModel& model = models.emplace_back();
    model.action = action;
    if (action.skill) model.skill_settings = SettingsOf(*action.skill);
  }
  ReadSecModels(sec_config, {domain.vocabulary(), parts}, &models);
  return models;
}

Domain LoadDomain(const Deployment& deployment, const Config& config,
                  const Config& sec_config, const PartTable& parts,
                  LearnedRules learned_rules) {
  Domain domain = Domain::FromConfig(config, parts);
  const auto file = config.GetOr<std::string>(kLearnedRulesKey, "");
  if (!file.empty() && learned_rules == LearnedRules::kRead) {
    ReadLearnedRules(deployment, config, &domain);
  }
  std::set<std::string> shown;
  for (const auto& [name, model] : sec_config["models"].Entries()) {
    shown.insert(name);
  }
  CompleteActions(shown, &domain);
  return domain;
}

}  // namespace

std::shared_ptr<const PredicateSensor> Task::MakeSensor(
    const PoseUncertainty& uncertainty) const {
  return std::make_shared<const PredicateSensor>(
      domain.vocabulary(), parts, layout.workspace, geometries, uncertainty);
}

Task LoadTask(const Deployment& deployment, LearnedRules learned_rules) {
  const Config parts_config = deployment.OfTask("parts.yaml");
  const Config domain_config = deployment.OfTask("domain.yaml");
  const Config sec_config = deployment.OfTask(kSecModelsFile);
  const PartTable parts = PartTable::FromConfig(parts_config);
  const CellLayout layout =
      CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  const Domain domain =
      LoadDomain(deployment, domain_config, sec_config, parts, learned_rules);
  Task task{parts,
            layout,
            SceneObjects(parts, layout),
            domain,
            ReadGeometries(domain_config, domain.vocabulary(), parts),
            ReadActions(sec_config, domain, parts)};
  domain_config.Finish();
  CheckGrasps(parts_config, parts, layout);
  CheckActions(domain_config, domain, parts, layout);
  CheckReports(domain_config, domain, layout);
  return task;
}

}  // namespace cell
