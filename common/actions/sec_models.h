#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/actions/action_model.h"
#include "common/actions/action_models.h"
#include "common/config/config.h"
#include "common/sec/learned_model.h"
#include "common/sec/scene_words.h"
#include "common/sec/sec_library.h"

namespace cell {

/// File of a task: the models that were learned of its actions, by name.
///
///   models:
///     Insert: {roles: {X: bolt, Y: hole}, moved: X, ...}
inline constexpr char kSecModelsFile[] = "sec_models.yaml";

/// Reads the model of an action, whose roles must be the action's arguments;
/// their types may be narrower.
/// @throws ConfigError naming file:key.
LearnedModel ReadSecModel(const Config& config, const Action& action,
                          const SceneWords& words);

/// Gives each action its model of the file; those without one are never
/// recognised.
/// @throws ConfigError naming file:key; also for a name that no action has.
void ReadSecModels(const Config& file, const SceneWords& words,
                   std::vector<ActionModel>* actions);

/// The file that is read as these models, without a comment at its head.
std::string SecModelsText(const std::map<std::string, LearnedModel>& models,
                          const Vocabulary& vocabulary);

/// The library of what is known of each action.
std::shared_ptr<const SecLibrary> MakeSecLibrary(const ActionModels& actions);

}  // namespace cell
