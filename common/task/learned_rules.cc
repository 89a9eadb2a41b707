#include "common/task/learned_rules.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_world.h"
#include "common/rules/rule_error.h"
#include "common/rules/rule_text.h"

namespace cell {
namespace {

[[noreturn]] void Fail(const std::string& file, int line,
                       const std::string& what) {
  throw ConfigError(fmt::format("{}:{}: {}", file, line, what));
}

/// The rules by the place of their action.
std::map<int, std::vector<NdrRule>> RulesByAction(const std::string& text,
                                                  const std::string& file,
                                                  const RuleWorld& world) {
  std::map<int, std::vector<NdrRule>> by_action;
  for (const auto& [line, rule] :
       rules::ParseRulesOf(world.world()->shared_symbols(), text, file)) {
    const int place = world.ActionOf(rule.action);
    const Action& action = world.actions()[static_cast<size_t>(place)];
    if (!action.rules.empty()) {
      Fail(file, line,
           "'" + action.name +
               "' has rules in domain.yaml already; remove those or these");
    }
    const Result<NdrRule> converted = ToNdrRule(rule, world);
    if (!converted) Fail(file, line, converted.reason());
    by_action[place].push_back(*converted);
  }
  return by_action;
}

}  // namespace

void PutLearnedRules(const std::string& text, const std::string& file,
                     Domain* domain) try {
  const RuleWorld world(
      std::make_shared<const Vocabulary>(domain->vocabulary()),
      domain->actions());
  auto by_action = RulesByAction(text, file, world);
  if (by_action.empty()) {
    throw ConfigError(file +
                      ": holds no rule; cell learn rules --out makes such a "
                      "file");
  }
  for (auto& [place, rules] : by_action) {
    Action action = domain->actions()[static_cast<size_t>(place)];
    action.rules = std::move(rules);
    domain->Put(action);
  }
} catch (const rules::RuleError& e) {
  throw ConfigError(e.what());
}

void ReadLearnedRules(const Deployment& deployment, const Config& domain_config,
                      Domain* domain) {
  const auto name = domain_config.Get<std::string>(kLearnedRulesKey);
  const std::filesystem::path path = deployment.task_dir / name;
  if (!std::filesystem::is_regular_file(path)) {
    domain_config[kLearnedRulesKey].Fail(
        "there is no file '" + name +
        "' in the task's folder; cell learn rules --out makes one");
  }
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) throw ConfigError(path.string() + ": cannot be read");
  PutLearnedRules(text.str(), path.string(), domain);
}

}  // namespace cell
