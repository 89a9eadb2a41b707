#include "common/predicates/clearance_column.h"

#include <fmt/format.h>

#include <stdexcept>

namespace cell {
namespace {

Part Column(double radius, double low, double high) {
  if (!(radius > 0) || !(high > low)) {
    throw std::invalid_argument(fmt::format(
        "no column of radius {} m from {} to {} m", radius, low, high));
  }
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.X_OP.translation().z() = (low + high) / 2;
  piece.radius = radius;
  piece.half_length = (high - low) / 2;
  Part part;
  part.name = "column";
  part.pieces = {piece};
  return part;
}

}  // namespace

ClearanceColumn::ClearanceColumn(double radius, double low, double high)
    : column_(std::make_shared<const PartShape>(Column(radius, low, high))) {}

bool ClearanceColumn::IsBlockedBy(const PartShape& part,
                                  const Eigen::Isometry3d& X_WO,
                                  const Eigen::Isometry3d& X_WC) const {
  constexpr double kContact = 1e-6;
  return PartShape::Distance(*column_, X_WC, part, X_WO, kContact) < kContact;
}

}  // namespace cell
