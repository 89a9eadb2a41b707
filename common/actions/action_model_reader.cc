#include "common/actions/action_model_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "common/actions/sec_models.h"
#include "common/actions/skill_needs.h"

namespace cell {
namespace {

// Aliases can expand to more nodes than memory holds.
constexpr char kAnchors[] = "&*";

std::string Indented(const std::string& text) {
  std::istringstream lines(text);
  std::string indented;
  for (std::string line; std::getline(lines, line);) {
    indented.append("  ").append(line).append("\n");
  }
  return indented;
}

YAML::Node Block(const std::string& text, const std::string& where) {
  if (text.find_first_of(kAnchors) != std::string::npos) {
    throw ConfigError(where +
                      ": anchors and aliases (& and *) are not supported");
  }
  // yaml-cpp stops silently where a document ends too early, and LoadAll() may
  // never return: this word behind the text must have been read.
  constexpr char kBehind[] = "behind";
  try {
    const YAML::Node node =
        YAML::Load("text:\n" + Indented(text) + kBehind + ": it\n");
    if (node.IsMap() && node.size() == 2 && node[kBehind].IsDefined()) {
      return node["text"];
    }
  } catch (const YAML::Exception& e) {
    throw ConfigError(where + ": not YAML: " + e.msg);
  }
  throw ConfigError(where + ": not one complete YAML document");
}

[[noreturn]] void Fail(const ActionRecord& record, const std::string& key,
                       const std::string& what) {
  throw ConfigError(record.name + ":" + key + ": " + what);
}

void RequireNothingSaid(const ActionRecord& record) {
  for (const std::string* text :
       {&record.undoes, &record.sec, &record.rules, &record.robot,
        &record.skill, &record.skill_settings}) {
    if (text->empty()) continue;
    Fail(record, "agents",
         "names no agent: that removes the action, but more is said of it; "
         "name person, robot, or both");
  }
}

/// The action in the form of a task's domain.yaml, with its event chain and
/// without `undoes`.
Config ConfigOf(const ActionRecord& record) {
  YAML::Node node(YAML::NodeType::Map);
  node["arguments"] = YAML::Node(YAML::NodeType::Map);
  for (const auto& [name, type] : record.arguments) {
    if (node["arguments"][name].IsDefined()) {
      throw ConfigError(record.name + ":arguments: two are named '" + name +
                        "'");
    }
    node["arguments"][name] = type;
  }
  if (record.is_removed()) {
    RequireNothingSaid(record);
    node["agents"].push_back("person");  // read, and dropped then
    node["rules"] = YAML::Node(YAML::NodeType::Sequence);
    return Config::Parse(YAML::Dump(node), record.name, false);
  }
  node["agents"] = record.agents;
  const std::pair<const char*, const std::string*> blocks[] = {
      {"sec", &record.sec},
      {"rules", &record.rules},
      {"robot", &record.robot},
      {"skill", &record.skill}};
  for (const auto& [key, text] : blocks) {
    if (text->size() > ActionRecord::kMaxBytes) {
      throw ConfigError(
          fmt::format("{}:{}: {} bytes are too many; at most {} are read",
                      record.name, key, text->size(), ActionRecord::kMaxBytes));
    }
    if (!text->empty()) node[key] = Block(*text, record.name + ":" + key);
  }
  return Config::Parse(YAML::Dump(node), record.name, false);
}

std::optional<int> FindUndone(const ActionRecord& record, const Action& action,
                              const Domain& domain) {
  if (record.undoes.empty()) return std::nullopt;
  const auto undone = domain.FindAction(record.undoes);
  if (!undone) {
    Fail(record, "undoes", "there is no action '" + record.undoes + "'");
  }
  if (!domain.actions()[*undone].TakesArgumentsOf(action)) {
    Fail(record, "undoes", "'" + record.undoes + "' takes other arguments");
  }
  return undone;
}

/// What is bound by one version must make sense in the next one.
void RequireSameArguments(const ActionRecord& record, const Action& action,
                          const Domain& domain) {
  const auto known = domain.FindAction(record.name);
  if (!known) return;
  const Action& kept = domain.actions()[*known];
  if (kept.TakesArgumentsOf(action)) return;
  std::vector<std::string> types;
  for (const Variable& argument : kept.arguments) {
    types.push_back(domain.vocabulary().types().name(argument.type));
  }
  Fail(record, "arguments",
       fmt::format("a new version must keep those of the last: {}",
                   fmt::join(types, ", ")));
}

Action ActionFrom(const Config& config, const ActionRecord& record,
                  const Domain& domain) {
  if (record.rules.empty() && !record.is_removed()) {
    Fail(record, "rules", "missing");
  }
  Action action = LoadAction(record.name, config, domain.vocabulary());
  if (record.is_removed()) action.agents.clear();
  RequireSameArguments(record, action, domain);
  action.undoes = FindUndone(record, action, domain);
  return WithSkillNeeds(std::move(action), domain.vocabulary());
}

/// Calls `read`, and turns what yaml-cpp throws for keys that are not names
/// into a ConfigError.
template <class Function>
auto Guarded(const ActionRecord& record, Function read) {
  try {
    return read(ConfigOf(record));
  } catch (const YAML::Exception& e) {
    throw ConfigError(record.name + ": not valid YAML of a domain: " + e.msg);
  }
}

}  // namespace

Action ReadAction(const ActionRecord& record, const Domain& domain) {
  return Guarded(record, [&](const Config& config) {
    return ActionFrom(config, record, domain);
  });
}

ActionModel ReadActionModel(const ActionRecord& record, const Domain& domain,
                            const PartTable& parts) {
  return Guarded(record, [&](const Config& config) {
    ActionModel model{record.version,
                      ActionFrom(config, record, domain),
                      {},
                      record.skill_settings};
    if (config.Has("sec")) {
      model.sec = ReadSecModel(config["sec"], model.action,
                               {domain.vocabulary(), parts});
    }
    config.Finish();
    return model;
  });
}

}  // namespace cell
