#include "common/rendering/body.h"

namespace cell {
namespace {

constexpr int kSidesOfCylinder = 64;

void Add(const Piece& piece, RenderBody& body) {
  const Piece hull = AsHull(piece, kSidesOfCylinder);
  const auto first = static_cast<uint32_t>(body.vertices.size());
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    body.vertices.push_back(vertex.cast<float>());
  }
  for (const std::vector<int>& face : hull.faces) {
    for (size_t i = 2; i < face.size(); ++i) {
      body.triangles.push_back({first + static_cast<uint32_t>(face[0]),
                                first + static_cast<uint32_t>(face[i - 1]),
                                first + static_cast<uint32_t>(face[i])});
    }
  }
}

}  // namespace

RenderBody BodyOf(const Part& part) {
  RenderBody body;
  body.name = part.name;
  body.colour = part.colour;
  for (const Piece& piece : part.pieces) {
    if (piece.is_shape) Add(piece, body);
  }
  return body;
}

RenderBody BoxBody(const std::string& name, const Eigen::Vector3d& half_extents,
                   const std::array<double, 3>& colour) {
  RenderBody body;
  body.name = name;
  body.colour = colour;
  Piece box;
  box.kind = Piece::Kind::kBox;
  box.half_extents = half_extents;
  Add(box, body);
  return body;
}

RenderBody PlaneBody(const std::string& name, double half_width,
                     const std::array<double, 3>& colour) {
  const auto w = static_cast<float>(half_width);
  RenderBody body;
  body.name = name;
  body.colour = colour;
  body.vertices = {{-w, -w, 0}, {w, -w, 0}, {w, w, 0}, {-w, w, 0}};
  body.triangles = {{0, 1, 2}, {0, 2, 3}};
  return body;
}

}  // namespace cell
