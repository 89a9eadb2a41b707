#include "common/scene/scene_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

std::vector<std::string> HandNames(const CellLayout& layout) {
  std::vector<std::string> names;
  for (const auto& hand : layout.AllHands()) names.push_back(hand.name);
  return names;
}

}  // namespace

SceneObjects::SceneObjects(const PartTable& parts,
                           std::vector<std::string> hands)
    : hands_(std::move(hands)) {
  std::sort(hands_.begin(), hands_.end());
  for (const Part& part : parts.parts()) parts_.push_back(part.name);
  names_ = parts_;
  names_.insert(names_.end(), hands_.begin(), hands_.end());
  names_.push_back(kTable);
  std::sort(names_.begin(), names_.end());
  const auto duplicate = std::adjacent_find(names_.begin(), names_.end());
  if (duplicate != names_.end()) {
    throw std::invalid_argument(
        fmt::format("two objects in the scene are named '{}'", *duplicate));
  }
}

SceneObjects::SceneObjects(const PartTable& parts, const CellLayout& layout)
    : SceneObjects(parts, HandNames(layout)) {}

bool SceneObjects::Has(const std::string& name) const {
  return std::binary_search(names_.begin(), names_.end(), name);
}

bool SceneObjects::IsHand(const std::string& name) const {
  return std::binary_search(hands_.begin(), hands_.end(), name);
}

bool SceneObjects::IsPart(const std::string& name) const {
  return Has(name) && !IsHand(name) && name != kTable;
}

}  // namespace cell
