#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"

namespace cell {

/// The types of a domain's objects: a tree below `object`. Types are indices.
class TypeHierarchy {
 public:
  static constexpr int kObject = 0;

  /// Reads a map from each type to its parent, e.g. {tool: object, saw: tool}.
  /// @throws ConfigError for unknown parents, cycles, and `object` as a key.
  static TypeHierarchy FromConfig(const Config& config);

  std::optional<int> Find(const std::string& name) const;
  const std::string& name(int type) const { return names_.at(type); }
  int size() const { return static_cast<int>(names_.size()); }
  /// True if every object of `type` is one of `ancestor`; a type is itself.
  bool IsA(int type, int ancestor) const;

 private:
  std::vector<std::string> names_ = {"object"};
  std::vector<int> parents_ = {kObject};
};

}  // namespace cell
