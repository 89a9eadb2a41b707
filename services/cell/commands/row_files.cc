#include "services/cell/commands/row_files.h"

#include <filesystem>

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

bool IsHidden(const fs::path& path) {
  return path.filename().string().starts_with('.');
}

void AddFolder(const fs::path& folder, const fs::path& name,
               RowIdentity* identity) {
  for (auto it = fs::recursive_directory_iterator(folder);
       it != fs::recursive_directory_iterator(); ++it) {
    if (IsHidden(it->path())) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file()) {
      const fs::path file = name / fs::relative(it->path(), folder);
      identity->AddFile(file.string(), TextOfFile(it->path()));
    }
  }
}

}  // namespace

void AddDeployment(const Deployment& deployment, RowIdentity* identity) {
  AddFolder(deployment.config_dir, "config", identity);
  AddFolder(deployment.task_dir, "tasks" / deployment.task_dir.filename(),
            identity);
}

void AddExperiences(const ExperienceFiles& files, RowIdentity* identity) {
  identity->AddFile("the file of experiences", TextOfFile(files.data));
  identity->AddFile("the file of symbols", TextOfFile(files.symbols));
}

}  // namespace cell::cli
