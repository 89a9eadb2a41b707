#pragma once

#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// What can appear in a scene: the parts of a task, the hands, the table. What
/// messages call by another name is rejected.
class SceneObjects {
 public:
  static constexpr char kTable[] = "table";

  /// @throws std::invalid_argument for duplicate names.
  SceneObjects(const PartTable& parts, std::vector<std::string> hands);
  SceneObjects(const PartTable& parts, const CellLayout& layout);

  /// All names, sorted.
  const std::vector<std::string>& names() const { return names_; }
  /// Sorted.
  const std::vector<std::string>& hands() const { return hands_; }
  /// In the order of the part table.
  const std::vector<std::string>& parts() const { return parts_; }

  bool Has(const std::string& name) const;
  bool IsHand(const std::string& name) const;
  bool IsPart(const std::string& name) const;

 private:
  std::vector<std::string> parts_;
  std::vector<std::string> hands_;
  std::vector<std::string> names_;
};

}  // namespace cell
