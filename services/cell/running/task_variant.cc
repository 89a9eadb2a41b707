#include "services/cell/running/task_variant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "common/config/config.h"
#include "common/files/draft.h"
#include "common/recordings/recording_file.h"
#include "common/task/task.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".yaml";

/// @throws ConfigError also for what yaml-cpp would silently drop, such as a
/// key that is there twice.
YAML::Node Load(const fs::path& file) {
  Config::Load(file.string());
  return YAML::LoadFile(file.string());
}

/// The same content without aliases: what one key refers to can be changed
/// without changing what the others refer to.
YAML::Node WithoutAliases(const YAML::Node& node) {
  if (!node.IsMap() && !node.IsSequence()) return YAML::Clone(node);
  YAML::Node copy(node.Type());
  copy.SetStyle(node.Style());
  for (const auto& entry : node) {
    if (node.IsMap()) {
      copy[YAML::Clone(entry.first)] = WithoutAliases(entry.second);
    } else {
      copy.push_back(WithoutAliases(entry));
    }
  }
  return copy;
}

/// A variant's file, for errors.
class Variant {
 public:
  explicit Variant(fs::path file) : file_(std::move(file)) {}

  const fs::path& file() const { return file_; }

  /// @param where  the keys to `key`
  [[noreturn]] void Fail(const std::string& where, const YAML::Node& key,
                         const std::string& message) const {
    throw ConfigError(ConfigMessage(file_.string(), where + key.Scalar(),
                                    key.Mark().line + 1, message));
  }

  /// @param where  the keys to `change`, each followed by a colon
  void Merge(const YAML::Node& change, const std::string& where,
             YAML::Node node) const {
    for (const auto& entry : change) {
      const std::string& key = entry.first.Scalar();
      if (entry.second.IsNull()) {
        if (!node.remove(key)) {
          Fail(where, entry.first, "would be removed, but is not there");
        }
      } else if (entry.second.IsMap() && node[key] && node[key].IsMap()) {
        Merge(entry.second, where + key + ":", node[key]);
      } else {
        node[key] = entry.second;
      }
    }
  }

 private:
  fs::path file_;
};

/// @throws ConfigError: what is wrong in a file of the changed task is, as long
/// as the task itself is sound, wrong under the same key of the variant.
void CheckVaried(const Deployment& varied, const fs::path& variant) {
  try {
    const Task task = LoadTask(varied);
    vtb::Demonstrations::FromConfig(varied.OfTask("demonstrators.yaml"),
                                    task.parts);
  } catch (const ConfigError& e) {
    std::string what = e.what();
    const std::string folder = (varied.task_dir / "").string();
    if (what.starts_with(folder)) what.erase(0, folder.size());
    throw ConfigError(variant.string() + ": " + what);
  }
}

}  // namespace

std::vector<std::string> VariantsOf(const fs::path& task_dir) {
  std::vector<std::string> names;
  if (!fs::is_directory(task_dir / kVariantsFolder)) return names;
  for (const auto& entry : fs::directory_iterator(task_dir / kVariantsFolder)) {
    if (entry.path().extension() != kExtension) continue;
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

void ApplyVariant(const fs::path& task_dir, const std::string& name,
                  const fs::path& varied_dir) {
  const auto known = VariantsOf(task_dir);
  if (!std::ranges::binary_search(known, name)) {
    throw std::runtime_error(fmt::format(
        "{}: the task has no variant '{}'{}{}", task_dir.string(), name,
        known.empty() ? "" : "; known: ", fmt::join(known, ", ")));
  }
  const Variant variant(task_dir / kVariantsFolder / (name + kExtension));
  const YAML::Node changes = Load(variant.file());
  if (!changes.IsMap()) {
    throw ConfigError(variant.file().string() + ": should be a map from files");
  }
  for (const auto& entry : changes) {
    const std::string& file = entry.first.Scalar();
    if (!fs::is_regular_file(task_dir / file)) {
      variant.Fail("", entry.first, "the task has no such file");
    }
    if (fs::path(file).extension() != kExtension) {
      variant.Fail("", entry.first, "only YAML files can be varied");
    }
    if (!entry.second.IsMap()) {
      variant.Fail("", entry.first, "should be a map");
    }
    const YAML::Node content = WithoutAliases(Load(task_dir / file));
    variant.Merge(entry.second, file + ":", content);
    WriteFile(varied_dir / file, YAML::Dump(content) + "\n");
  }
}

VariedTask::VariedTask(const Deployment& source, const std::string& variant)
    : folder_("task"), deployment_(source) {
  deployment_.task_dir =
      folder_.path() / (source.task_dir / "").parent_path().filename();
  fs::create_directory(deployment_.task_dir);
  for (const auto& entry : fs::directory_iterator(source.task_dir)) {
    const fs::path name = entry.path().filename();
    if (name == kRecordingsFolder) continue;
    fs::copy(entry.path(), deployment_.task_dir / name,
             fs::copy_options::recursive);
  }
  ApplyVariant(source.task_dir, variant, deployment_.task_dir);
  CheckVaried(deployment_,
              source.task_dir / kVariantsFolder / (variant + kExtension));
}

}  // namespace cell::cli
