#include "common/actions/record_messages.h"

namespace cell {

action_record_t ToMessage(const ActionRecord& record) {
  action_record_t message{};
  message.id = record.id;
  message.version = record.version;
  message.name = record.name;
  for (const auto& [name, type] : record.arguments) {
    variable_t& argument = message.arguments.emplace_back();
    argument.name = name;
    argument.type = type;
  }
  message.num_arguments = static_cast<int32_t>(message.arguments.size());
  message.agents = record.agents;
  message.num_agents = static_cast<int32_t>(message.agents.size());
  message.undoes = record.undoes;
  message.sec = record.sec;
  message.rules = record.rules;
  message.robot = record.robot;
  message.skill = record.skill;
  message.skill_settings = record.skill_settings;
  return message;
}

ActionRecord FromMessage(const action_record_t& message) {
  ActionRecord record;
  record.id = message.id;
  record.version = message.version;
  record.name = message.name;
  for (const variable_t& argument : message.arguments) {
    record.arguments.push_back({argument.name, argument.type});
  }
  record.agents = message.agents;
  record.undoes = message.undoes;
  record.sec = message.sec;
  record.rules = message.rules;
  record.robot = message.robot;
  record.skill = message.skill;
  record.skill_settings = message.skill_settings;
  return record;
}

}  // namespace cell
