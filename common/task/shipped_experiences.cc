#include "common/task/shipped_experiences.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "common/config/config.h"
#include "common/experiences/experience_text.h"
#include "common/experiences/rule_world.h"
#include "common/rules/rule_error.h"
#include "common/task/learned_rules.h"

namespace cell {

namespace fs = std::filesystem;

std::vector<fs::path> ExperienceFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".experiences") {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::vector<TaskExperience> ReadShippedExperiences(const Deployment& deployment,
                                                   const Domain& domain) try {
  std::vector<TaskExperience> experiences;
  const Config config = deployment.OfTask("domain.yaml");
  if (!config.Has(kLearnedRulesKey)) return experiences;
  const RuleWorld world(std::make_shared<const Vocabulary>(domain.vocabulary()),
                        domain.actions());
  for (const fs::path& path :
       ExperienceFilesIn(deployment.task_dir / kExperiencesFolder)) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    const auto read = ReadExperiences(text.str(), path.string(), world);
    if (read.empty()) {
      throw ConfigError(path.string() + ": holds no experience");
    }
    for (const auto& e : read) {
      const GroundAction action = world.FromWorld(e.act);
      experiences.push_back(
          {domain.actions()[static_cast<size_t>(action.action)].name,
           action.arguments, Agent::kPerson, world.FromWorld(e.before),
           world.FromWorld(e.after)});
    }
  }
  return experiences;
} catch (const rules::RuleError& e) {
  throw ConfigError(e.what());
}

}  // namespace cell
