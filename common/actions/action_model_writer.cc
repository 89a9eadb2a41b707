#include "common/actions/action_model_writer.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <string>

#include "common/sec/learned_model_text.h"

namespace cell {
namespace {

using Variables = std::vector<Variable>;

/// A list or map on one line.
YAML::Node Flow(YAML::NodeType::value type) {
  YAML::Node node(type);
  node.SetStyle(YAML::EmitterStyle::Flow);
  return node;
}

std::vector<std::string> NamesOf(const std::vector<Agent>& agents) {
  std::vector<std::string> names;
  for (const Agent agent : agents) {
    names.emplace_back(agent == Agent::kPerson ? "person" : "robot");
  }
  return names;
}

Variables Joined(Variables variables, const Variables& more) {
  variables.insert(variables.end(), more.begin(), more.end());
  return variables;
}

class Writer {
 public:
  Writer(const Vocabulary& vocabulary, const Action& action)
      : vocabulary_(vocabulary), action_(action) {}

  std::string Rules() const {
    YAML::Node rules(YAML::NodeType::Sequence);
    for (const NdrRule& rule : action_.rules) rules.push_back(RuleNode(rule));
    return YAML::Dump(rules);
  }

  std::string Skill(const SkillBinding& skill) const {
    const auto text = [&](const Term& term) {
      return ToText(term, vocabulary_, action_.arguments);
    };
    YAML::Node node = Flow(YAML::NodeType::Map);
    node["name"] = skill.name;
    for (const auto& [name, term] : skill.arguments) node[name] = text(term);
    node["arm"] = text(skill.arm);
    return YAML::Dump(node);
  }

 private:
  YAML::Node LiteralsNode(const std::vector<Literal>& literals,
                          const Variables& variables) const {
    YAML::Node node = Flow(YAML::NodeType::Sequence);
    for (const Literal& literal : literals) {
      node.push_back(ToText(literal, vocabulary_, variables));
    }
    return node;
  }

  YAML::Node VariablesNode(const Variables& variables) const {
    YAML::Node node = Flow(YAML::NodeType::Map);
    for (const Variable& variable : variables) {
      node[variable.name] = vocabulary_.types().name(variable.type);
    }
    return node;
  }

  YAML::Node RuleNode(const NdrRule& rule) const {
    YAML::Node node(YAML::NodeType::Map);
    if (rule.agents != action_.agents) node["agents"] = NamesOf(rule.agents);
    Variables variables = action_.arguments;
    for (const DeicticReference& reference : rule.references) {
      variables.push_back(reference.variable);
      YAML::Node entry(YAML::NodeType::Map);
      entry["type"] = vocabulary_.types().name(reference.variable.type);
      entry["such_that"] = LiteralsNode(reference.literals, variables);
      node["references"][reference.variable.name] = entry;
    }
    node["context"] = LiteralsNode(rule.context, variables);
    node["outcomes"] = YAML::Node(YAML::NodeType::Sequence);
    for (const Outcome& outcome : rule.outcomes) {
      node["outcomes"].push_back(OutcomeNode(outcome, variables));
    }
    node["noise"] = fmt::format("{}", rule.noise);
    return node;
  }

  YAML::Node OutcomeNode(const Outcome& outcome,
                         const Variables& variables) const {
    YAML::Node node(YAML::NodeType::Map);
    node["probability"] = fmt::format("{}", outcome.probability);
    node["effects"] = YAML::Node(YAML::NodeType::Sequence);
    for (const Effect& effect : outcome.effects) {
      if (!effect.each.empty()) {
        const Variables all = Joined(variables, effect.each);
        YAML::Node entry(YAML::NodeType::Map);
        entry["each"] = VariablesNode(effect.each);
        entry["where"] = LiteralsNode(effect.where, all);
        entry["then"] = LiteralsNode(effect.then, all);
        node["effects"].push_back(entry);
        continue;
      }
      for (const Literal& literal : effect.then) {
        node["effects"].push_back(ToText(literal, vocabulary_, variables));
      }
    }
    return node;
  }

  const Vocabulary& vocabulary_;
  const Action& action_;
};

}  // namespace

ActionRecord WriteActionModel(const ActionModel& model, const Domain& domain) {
  const Action& action = model.action;
  const Writer writer(domain.vocabulary(), action);
  ActionRecord record;
  record.version = model.version;
  record.name = action.name;
  for (const Variable& argument : action.arguments) {
    record.arguments.push_back(
        {argument.name, domain.vocabulary().types().name(argument.type)});
  }
  record.agents = NamesOf(action.agents);
  if (action.undoes) record.undoes = domain.actions()[*action.undoes].name;
  if (model.sec) record.sec = ToText(*model.sec, domain.vocabulary());
  if (!action.agents.empty()) record.rules = writer.Rules();
  if (action.skill) record.skill = writer.Skill(*action.skill);
  record.skill_settings = model.skill_settings;
  return record;
}

std::vector<ActionRecord> WriteActionModels(std::span<const ActionModel> models,
                                            const Domain& domain) {
  std::vector<ActionRecord> records;
  for (const ActionModel& model : models) {
    records.push_back(WriteActionModel(model, domain));
  }
  return records;
}

}  // namespace cell
