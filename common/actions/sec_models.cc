#include "common/actions/sec_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "common/sec/learned_library.h"
#include "common/sec/learned_model_text.h"

namespace cell {

LearnedModel ReadSecModel(const Config& config, const Action& action,
                          const SceneWords& words) {
  LearnedModel model = LearnedModelFromConfig(config, words);
  const TypeHierarchy& types = words.vocabulary.types();
  const auto is_argument = [&](const Variable& role, const Variable& argument) {
    return role.name == argument.name && types.IsA(role.type, argument.type);
  };
  if (!std::ranges::equal(model.roles, action.arguments, is_argument)) {
    std::string arguments;
    for (const Variable& argument : action.arguments) {
      arguments += fmt::format("{}{}: {}", arguments.empty() ? "" : ", ",
                               argument.name, types.name(argument.type));
    }
    config["roles"].Fail(
        fmt::format("should be the arguments of {}, or narrower: {}",
                    action.name, arguments));
  }
  return model;
}

void ReadSecModels(const Config& file, const SceneWords& words,
                   std::vector<ActionModel>* actions) {
  for (const auto& [name, config] : file["models"].Entries()) {
    const auto model = std::ranges::find_if(
        *actions, [&](const auto& m) { return m.action.name == name; });
    if (model == actions->end()) {
      config.Fail("domain.yaml has no action '" + name + "'");
    }
    model->sec = ReadSecModel(config, model->action, words);
  }
  file.Finish();
}

std::string SecModelsText(const std::map<std::string, LearnedModel>& models,
                          const Vocabulary& vocabulary) {
  std::string text = models.empty() ? "models: {}\n" : "models:\n";
  for (const auto& [name, model] : models) {
    text += "  " + name + ":\n";
    std::istringstream lines(ToText(model, vocabulary));
    for (std::string line; std::getline(lines, line);) {
      text += "    " + line + "\n";
    }
  }
  return text;
}

std::shared_ptr<const SecLibrary> MakeSecLibrary(const ActionModels& actions) {
  std::vector<LearnedLibrary::Entry> entries;
  for (const ActionModel& model : actions.models()) {
    if (model.sec) entries.push_back({model.action.name, *model.sec});
  }
  return std::make_shared<const LearnedLibrary>(
      std::move(entries), std::make_shared<const SceneWords>(SceneWords{
                              actions.domain().vocabulary(), actions.parts()}));
}

}  // namespace cell
