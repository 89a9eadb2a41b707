#include "common/relational/type_hierarchy.h"

#include <algorithm>
#include <map>
#include <set>

namespace cell {

TypeHierarchy TypeHierarchy::FromConfig(const Config& config) {
  TypeHierarchy types;
  const auto entries = config.Entries();
  for (const auto& [name, node] : entries) {
    if (types.Find(name)) node.Fail("is already the root of all types");
    types.names_.push_back(name);
  }
  for (const auto& [name, node] : entries) {
    const std::optional<int> parent = types.Find(node.As<std::string>());
    if (!parent) {
      node.Fail("the parent '" + node.As<std::string>() +
                "' is not a type; name one of this list, or object");
    }
    types.parents_.push_back(*parent);
  }
  for (const auto& [name, node] : entries) {
    std::set<int> above;
    for (int t = *types.Find(name); t != kObject; t = types.parents_[t]) {
      if (!above.insert(t).second) {
        node.Fail("the type '" + name + "' is its own ancestor");
      }
    }
  }
  return types;
}

std::optional<int> TypeHierarchy::Find(const std::string& name) const {
  const auto it = std::find(names_.begin(), names_.end(), name);
  if (it == names_.end()) return std::nullopt;
  return static_cast<int>(it - names_.begin());
}

bool TypeHierarchy::IsA(int type, int ancestor) const {
  while (type != ancestor && type != kObject) type = parents_.at(type);
  return type == ancestor;
}

}  // namespace cell
