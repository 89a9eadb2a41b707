#include "services/library/open_store.h"

#include "common/actions/action_model_writer.h"
#include "common/task/task.h"
#include "services/library/content_file.h"
#include "services/library/memory_action_store.h"
#include "services/library/sqlite_action_store.h"

namespace cell::library {

std::shared_ptr<ActionStore> OpenStore(const Deployment& deployment,
                                       const std::filesystem::path& database) {
  const auto& run_dir = deployment.run_dir;
  if (!deployment.repeated_dir.empty()) {
    return std::make_shared<MemoryActionStore>(
        ReadContent(deployment.repeated_dir / kStartContentName));
  }
  std::shared_ptr<ActionStore> store;
  if (database.empty() && run_dir.empty()) {
    store = std::make_shared<MemoryActionStore>();
  } else {
    store = std::make_shared<SqliteActionStore>(
        database.empty() ? run_dir / kDatabaseName : database,
        SqliteActionStore::Mode::kCreate);
  }
  if (store->Count() == 0) {
    const Task task = LoadTask(deployment);
    store->BeginChange("actions of the task " +
                       deployment.task_dir.filename().string());
    store->Store(WriteActionModels(task.actions, task.domain), kBeforeRun);
  }
  store->BeginChange(run_dir.empty() ? "a cell"
                                     : "run " + run_dir.filename().string());
  // A process that comes back within the run finds it there.
  const auto content = run_dir / kStartContentName;
  if (!run_dir.empty() && !std::filesystem::exists(content)) {
    WriteContent(content, store->Content());
  }
  return store;
}

}  // namespace cell::library
