#pragma once

#include <filesystem>
#include <string>

#include "common/config/config.h"

namespace cell {

/// The files that a cell runs by. A run folder keeps a copy of them.
struct Deployment {
  std::filesystem::path config_dir;  ///< one YAML per service
  std::filesystem::path task_dir;    ///< parts, domain, cell layout, scripts
  std::filesystem::path types_dir;   ///< texts of the message types, if there
  std::filesystem::path run_dir;  ///< where a run is recorded; empty: nowhere
  bool is_live = false;           ///< by the wall clock, not in lockstep
  bool has_operator = false;      ///< a person resumes a cell that holds
  /// A recorded run that is repeated from its own inputs; empty: none is.
  std::filesystem::path repeated_dir;

  /// deploy/config/<service>.yaml
  Config ForService(const std::string& service) const {
    return Config::Load(config_dir / (service + ".yaml"));
  }
  /// A file of the task, e.g. "parts.yaml".
  Config OfTask(const std::string& file) const {
    return Config::Load(task_dir / file);
  }
};

}  // namespace cell
