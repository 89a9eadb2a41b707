#include "common/rendering/cell_bodies.h"

#include <array>

#include "common/arms/arm_bodies.h"

namespace cell {
namespace {

using Colour = std::array<double, 3>;

constexpr double kHalfTable = 1.5;  // [m]
constexpr Colour kTableColour = {0.42, 0.38, 0.33};
constexpr Colour kHandColour = {0.82, 0.58, 0.45};

}  // namespace

std::vector<RenderBody> BodiesOf(const PartTable& parts,
                                 const CellLayout& layout) {
  std::vector<RenderBody> bodies;
  for (const Part& part : parts.parts()) bodies.push_back(BodyOf(part));
  const auto add_hand = [&](const std::string& name, const HandType& type,
                            const Colour& colour) {
    for (const HandType::Box& box : type.boxes) {
      bodies.push_back(
          BoxBody(name + "." + box.name, box.half_extents, colour));
    }
  };
  for (const auto& hand : layout.hands) {
    add_hand(hand.name, hand.type, kHandColour);
  }
  for (const ArmLayout& arm : layout.arms) {
    for (const Part& body : BodyPartsOf(arm)) bodies.push_back(BodyOf(body));
  }
  bodies.push_back(PlaneBody("table", kHalfTable, kTableColour));
  bodies.back().X_WO = Eigen::Isometry3d::Identity();
  bodies.push_back(BodyOf(PedestalBody(layout.pedestal)));
  bodies.back().X_WO = layout.pedestal.X_WP;
  return bodies;
}

}  // namespace cell
