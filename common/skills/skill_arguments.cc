#include "common/skills/skill_arguments.h"

namespace cell {
namespace {

constexpr size_t kMaxArguments = 16;

}  // namespace

std::optional<SkillArguments> ArgumentsOf(const asked_skill_t& request) {
  if (request.arguments.size() > kMaxArguments) return std::nullopt;
  SkillArguments arguments;
  for (const argument_t& argument : request.arguments) {
    if (argument.name.empty() ||
        !arguments.emplace(argument.name, argument.value).second) {
      return std::nullopt;
    }
  }
  return arguments;
}

std::string ArgumentOf(const asked_skill_t& request, const std::string& name) {
  for (const argument_t& argument : request.arguments) {
    if (argument.name == name) return argument.value;
  }
  return "";
}

void SetArguments(const SkillArguments& arguments, asked_skill_t* request) {
  request->arguments.clear();
  for (const auto& [name, value] : arguments) {
    request->arguments.push_back({name, value});
  }
  request->num_arguments = static_cast<int32_t>(request->arguments.size());
}

}  // namespace cell
