#include "services/library/record_language.h"

#include <yaml-cpp/yaml.h>

#include <sstream>

namespace cell::library {
namespace {

// An alias in a text could stand for more than memory holds.
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
    throw ConfigError(where + ": anchors and aliases (& and *) cannot be kept");
  }
  // yaml-cpp stops in silence where a document ends too early, and LoadAll()
  // may not come to an end at all: what comes behind the text must be there.
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
  throw ConfigError(where + ": not one whole YAML document");
}

std::string TextOr(const Config& config, const std::string& key) {
  return config.Has(key) ? config[key].Text() : "";
}

// The section of skills.yaml that has the figures of the kind.
std::string SettingsOf(const Config& skill) {
  return skill.Get<std::string>("kind") == "insert" ? "insertion" : "motion";
}

}  // namespace

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
  node["agents"] = record.agents;
  const std::pair<const char*, const std::string*> blocks[] = {
      {"sec", &record.sec},
      {"rules", &record.rules},
      {"robot", &record.robot},
      {"skill", &record.skill}};
  for (const auto& [key, text] : blocks) {
    if (!text->empty()) node[key] = Block(*text, record.name + ":" + key);
  }
  return Config::Parse(YAML::Dump(node), record.name, false);
}

std::vector<ActionRecord> TaskActions(const Config& domain_config) {
  std::vector<ActionRecord> records;
  for (const auto& [name, config] : domain_config["actions"].Entries()) {
    ActionRecord& record = records.emplace_back();
    record.name = name;
    for (const auto& [argument, type] : config["arguments"].Entries()) {
      record.arguments.push_back({argument, type.As<std::string>()});
    }
    record.agents =
        config.GetOr<std::vector<std::string>>("agents", {"person", "robot"});
    record.undoes = config.GetOr<std::string>("undoes", "");
    record.sec = TextOr(config, "sec");
    record.rules = config["rules"].Text();
    record.robot = TextOr(config, "robot");
    record.skill = TextOr(config, "skill");
    if (!record.skill.empty()) {
      record.skill_settings = SettingsOf(config["skill"]);
    }
  }
  return records;
}

}  // namespace cell::library
