#include "common/layout/hand_type.h"

#include <algorithm>

#include "common/layout/vectors.h"

namespace cell {
namespace {

HandType::BoxPlace PlaceFromConfig(const Config& config) {
  HandType::BoxPlace place;
  place.X_GB = PoseFromConfig(config);
  if (config.Has("slide")) place.slide = Vector3(config, "slide");
  return place;
}

HandType HandTypeFromConfig(const std::string& name, const Config& config) {
  HandType type;
  type.name = name;
  type.max_opening = config.Number("max_opening", 0.001, 1);
  const Config boxes = config["boxes"];
  for (const auto& [box, size] : boxes.Entries()) {
    type.boxes.push_back({box, Vector3(boxes, box) / 2});
    if (!(type.boxes.back().half_extents.minCoeff() > 0)) {
      size.Fail("has no volume");
    }
  }
  if (type.boxes.empty()) boxes.Fail("a hand has at least one box");
  for (const auto& [grip_name, grip_config] : config["grips"].Entries()) {
    HandType::Grip& grip = type.grips.emplace_back();
    grip.name = grip_name;
    for (const HandType::Box& box : type.boxes) {
      grip.places.push_back(PlaceFromConfig(grip_config[box.name]));
    }
  }
  if (type.grips.empty()) config["grips"].Fail("a hand has at least one grip");
  return type;
}

}  // namespace

std::vector<HandType::Box> HandType::Fingers() const {
  std::vector<Box> fingers;
  for (size_t i = 0; i < boxes.size(); ++i) {
    const bool is_finger = std::ranges::any_of(
        grips, [&](const Grip& grip) { return IsFinger(grip.places[i]); });
    if (is_finger) fingers.push_back(boxes[i]);
  }
  return fingers;
}

const HandType::Grip* HandType::FindGrip(const std::string& grip) const {
  for (const Grip& known : grips) {
    if (known.name == grip) return &known;
  }
  return nullptr;
}

Eigen::Isometry3d HandType::PlaceOf(const Grip& grip, size_t index,
                                    double opening) {
  const BoxPlace& place = grip.places.at(index);
  Eigen::Isometry3d X_GB = place.X_GB;
  X_GB.translation() += place.slide * (opening / 2);
  return X_GB;
}

bool HandType::IsFinger(const BoxPlace& place) {
  return place.slide != Eigen::Vector3d::Zero();
}

std::map<std::string, HandType> HandTypesFromConfig(const Config& config) {
  std::map<std::string, HandType> types;
  for (const auto& [name, type] : config.Entries()) {
    types.emplace(name, HandTypeFromConfig(name, type));
  }
  return types;
}

}  // namespace cell
