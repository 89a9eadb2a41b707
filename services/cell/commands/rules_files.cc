#include "services/cell/commands/rules_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "common/rules/data_text.h"
#include "common/rules/rule_text.h"
#include "common/task/shipped_experiences.h"
#include "common/text/nearest.h"
#include "services/cell/learning/experienced_episodes.h"

namespace cell::cli {

namespace fs = std::filesystem;

std::string TextOfFile(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  if (!file.is_open() || fs::is_directory(path)) {
    throw std::runtime_error(path.string() + ": cannot be read");
  }
  return text.str();
}

ExperienceFiles FilesOfExperiences(const fs::path& data,
                                   const fs::path& symbols) {
  const fs::path file = fs::is_directory(data) ? data / "data.dat" : data;
  return {file, symbols.empty() ? file.parent_path() / "symbols.dat" : symbols};
}

rules::ExperienceSet LoadExperiences(const fs::path& data,
                                     const fs::path& symbols) {
  const auto [file, declarations] = FilesOfExperiences(data, symbols);
  const std::string text = TextOfFile(file);
  auto table =
      std::make_shared<const rules::SymbolTable>(rules::SymbolTable::Parse(
          TextOfFile(declarations), declarations.string()));
  rules::ExperienceSet set =
      rules::ParseExperiences(text, file.string(), std::move(table));
  if (set.experiences.empty()) {
    throw std::runtime_error(file.string() +
                             ": holds no experience: a state, "
                             "an action, and the state after it");
  }
  return set;
}

fs::path ExperiencesFolder(const std::string& named,
                           const Deployment& deployment) {
  return named.empty() ? deployment.task_dir / kExperiencesFolder
                       : fs::path(named);
}

std::vector<rules::Experience> TaskExperiences(const fs::path& folder,
                                               const RuleWorld& world) {
  std::vector<rules::Experience> experiences;
  for (ExperiencedEpisode& episode : EpisodesIn(folder, world)) {
    std::ranges::move(episode.experiences, std::back_inserter(experiences));
  }
  return experiences;
}

rules::NdrRules LoadRules(const fs::path& path) {
  rules::NdrRules rules = rules::ParseRules(TextOfFile(path), path.string());
  if (rules.rules.empty()) {
    throw std::runtime_error(path.string() +
                             ": holds no rule, which begins with 'Action: "
                             "NAME(X)'");
  }
  return rules;
}

const Goal& NamedGoal(const Domain& domain, const std::string& name) {
  if (name.empty()) return domain.goals().front();
  const Goal* goal = domain.FindGoal(name);
  if (goal == nullptr) {
    throw std::runtime_error(
        fmt::format("the task has no goal '{}'{}", name,
                    NamesInstead(name, NamesIn(domain.goals(), &Goal::name))));
  }
  return *goal;
}

}  // namespace cell::cli
