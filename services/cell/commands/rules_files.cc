#include "services/cell/commands/rules_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "common/experiences/experience_text.h"
#include "common/rules/data_text.h"
#include "common/rules/rule_text.h"

namespace cell::cli {

namespace fs = std::filesystem;
namespace {

constexpr char kExperiences[] = ".experiences";

}  // namespace

std::string TextOfFile(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  if (!file.is_open() || fs::is_directory(path)) {
    throw std::runtime_error(path.string() + ": cannot be read");
  }
  return text.str();
}

rules::ExperienceSet LoadExperiences(const fs::path& data,
                                     const fs::path& symbols) {
  const fs::path file = fs::is_directory(data) ? data / "data.dat" : data;
  const std::string text = TextOfFile(file);
  const fs::path declarations =
      symbols.empty() ? file.parent_path() / "symbols.dat" : symbols;
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

std::vector<rules::Experience> TaskExperiences(const fs::path& folder,
                                               const RuleWorld& world) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == kExperiences) {
        files.push_back(entry.path());
      }
    }
  }
  if (files.empty()) {
    throw std::runtime_error(folder.string() + ": has no file *" +
                             kExperiences +
                             "; cell rules record makes them from runs");
  }
  std::ranges::sort(files);
  std::vector<rules::Experience> experiences;
  for (const fs::path& file : files) {
    for (auto& experience :
         ReadExperiences(TextOfFile(file), file.string(), world)) {
      experiences.push_back(std::move(experience));
    }
  }
  return experiences;
}

rules::NdrRules LoadRules(const fs::path& path) {
  return rules::ParseRules(TextOfFile(path), path.string());
}

}  // namespace cell::cli
