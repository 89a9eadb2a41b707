#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/config/deployment.h"
#include "common/files/temporary_folder.h"

namespace cell::cli {

/// Changes of a task that a run can ask for: TASK/variants/NAME.yaml, a map
/// from each file of the task that differs to what differs in it. Maps are
/// merged key by key, `~` removes a key, and anything else replaces what is
/// there. E.g.
///
///   domain.yaml: {types: {long_bolt: bolt}}
///   parts.yaml: {parts: {bolt_1: {type: long_bolt, ...}}}
inline constexpr char kVariantsFolder[] = "variants";

/// The names of a task's variants, sorted.
std::vector<std::string> VariantsOf(const std::filesystem::path& task_dir);

/// Writes the files of a task's folder that a variant of it changes, into its
/// copy `varied_dir`. @throws ConfigError naming the file, key and line;
/// std::runtime_error naming the variants if there is none of the name.
void ApplyVariant(const std::filesystem::path& task_dir,
                  const std::string& name,
                  const std::filesystem::path& varied_dir);

/// A copy of a task's folder, changed by a variant, as long as this object
/// exists.
class VariedTask {
 public:
  /// @throws like ApplyVariant(); ConfigError naming the variant if the task
  /// makes no sense with it.
  VariedTask(const Deployment& source, const std::string& variant);

  const Deployment& deployment() const { return deployment_; }

 private:
  TemporaryFolder folder_;
  Deployment deployment_;
};

}  // namespace cell::cli
