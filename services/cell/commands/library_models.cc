#include "services/cell/commands/library_models.h"

#include "common/actions/action_model_reader.h"
#include "services/cell/commands/library_commands.h"
#include "services/library/sqlite_action_store.h"

namespace cell::cli {

RoleSimilarity::Models ModelsOf(const std::string& database, const Task& task) {
  RoleSimilarity::Models models;
  if (database.empty()) {
    for (const ActionModel& model : task.actions) {
      if (model.sec) models.emplace(model.action.name, *model.sec);
    }
    return models;
  }
  const library::SqliteActionStore store(
      LibraryFile(database), library::SqliteActionStore::Mode::kExisting);
  for (ActionRecord record : store.All()) {
    record.undoes.clear();  // it may undo one that only the library knows
    const ActionModel model = ReadActionModel(record, task.domain, task.parts);
    if (model.sec) models.emplace(record.name, *model.sec);
  }
  return models;
}

}  // namespace cell::cli
