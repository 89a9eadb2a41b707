#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "common/node/cell_files.h"

namespace cell::cli {

/// What the units of an installed cell are started with: lines KEY=VALUE of
/// deploy/systemd/environment.
class UnitEnvironment {
 public:
  /// Loads that of the system's cell, or of the user's own; it is optional.
  /// @throws ConfigError "file:KEY: message (line 3)" for keys CELL_... that no
  /// unit knows, and for what is no assignment.
  static UnitEnvironment Load(bool is_user);
  static UnitEnvironment Parse(const std::string& text,
                               const std::string& file);

  /// Holds it, and all files of the task, against each other as the units will
  /// find them. @throws ConfigError that names file and key.
  void Check(const CellFiles& files) const;

 private:
  struct Entry {
    std::string value;
    int line = 0;
  };

  /// Empty if it is not set.
  std::string ValueOf(const std::string& key) const;
  [[noreturn]] void Fail(const std::string& key,
                         const std::string& message) const;
  void RequireOneOf(const std::string& key, const char* flag) const;
  void CheckAddress() const;

  std::string file_;
  std::map<std::string, Entry> entries_;
};

}  // namespace cell::cli
