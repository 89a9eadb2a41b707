#include "common/parts/part_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "common/layout/cell_layout.h"

namespace cell {
namespace {

constexpr char kTable[] = R"(
contacts: [[block, table]]
parts:
  cube:
    type: block
    fits: [seat]
    symmetry_order: 4
    density: 1000
    colour: [1, 0, 0]
    pieces:
      - {kind: PIECE, contact: block}
    sites:
      - {name: top, type: seat, xyz: [0, 0, 50], approach: 100, opening: 20, depth: 10}
)";

constexpr char kBox[] = "box, center: [0, 0, 25], size: [50, 50, 50]";

std::string With(std::string text, const std::string& what,
                 const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

PartTable Load(const std::string& text) {
  return PartTable::FromConfig(Config::Parse(text, "parts.yaml"));
}

std::string ErrorOf(const std::string& text) {
  try {
    Load(text);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

Part WithPiece(const std::string& piece) {
  return Load(With(kTable, "PIECE", piece)).parts().at(0);
}

TEST(PartTable, NamesSitesByTheirHost) {
  const PartTable table = Load(With(kTable, "PIECE", kBox));
  const Site* site = table.FindSite("cube.top");
  ASSERT_NE(site, nullptr);
  EXPECT_EQ(site->host, "cube");
  EXPECT_NEAR(site->X_HS.translation().z(), 0.05, 1e-12);
  EXPECT_EQ(table.FindSite("cube.bottom"), nullptr);
  EXPECT_EQ(table.Find("ball"), nullptr);
}

TEST(PartTable, AGraspSuitsAPinchUnlessItNamesItsGrips) {
  const std::string good =
      With(kTable, "PIECE", kBox) +
      "    grasps:\n"
      "      - {xyz: [0, 0, 40], width: 50}\n"
      "      - {xyz: [0, 0, 40], width: 50, grips: [ball, two_finger_pinch]}\n";
  const std::vector<Grasp> grasps = Load(good).parts().at(0).grasps;
  EXPECT_THAT(grasps.at(0).grips, testing::ElementsAre("two_finger_pinch"));
  EXPECT_THAT(grasps.at(1).grips,
              testing::ElementsAre("ball", "two_finger_pinch"));
  EXPECT_THAT(ErrorOf(With(good, "[ball, two_finger_pinch]", "[]")),
              testing::StartsWith(
                  "parts.yaml:parts.cube.grasps[1].grips: names no grip"));
}

TEST(PartTable, RefusesImpossiblePartsByFileAndKey) {
  using testing::AllOf;
  using testing::HasSubstr;
  using testing::StartsWith;
  const std::string good = With(kTable, "PIECE", kBox);
  ASSERT_EQ(ErrorOf(good), "");
  EXPECT_THAT(ErrorOf(With(good, "size: [50, 50, 50]", "size: [50, 0, 50]")),
              AllOf(StartsWith("parts.yaml:parts.cube.pieces[0]"),
                    HasSubstr("no volume")));
  EXPECT_THAT(
      ErrorOf(With(good, "contact: block", "contact: blok")),
      AllOf(StartsWith("parts.yaml:parts.cube.pieces"), HasSubstr("blok")));
  EXPECT_THAT(
      ErrorOf(With(good, "fits: [seat]", "fits: [hole]")),
      AllOf(StartsWith("parts.yaml:parts.cube.fits"), HasSubstr("hole")));
  EXPECT_THAT(ErrorOf(With(good, "density: 1000", "density: -1")),
              StartsWith("parts.yaml:parts.cube.density"));
  EXPECT_THAT(ErrorOf(With(good, "density: 1000", "dnsity: 1000")),
              StartsWith("parts.yaml:parts.cube.density: missing"));
  EXPECT_THAT(ErrorOf(good + "    weight: 3\n"),
              StartsWith("parts.yaml:parts.cube.weight"));
  EXPECT_THAT(ErrorOf(With(good, "kind: box", "kind: blob")),
              StartsWith("parts.yaml:parts.cube.pieces[0].kind"));
}

/// A cover on a hinge, and a box on a slide, of a fixed cube.
std::string Articulated() {
  const std::string part =
      "    type: block\n    symmetry_order: 1\n    density: 1000\n"
      "    colour: [1, 0, 0]\n"
      "    pieces: [{kind: box, center: [0, 0, 0], size: [9, 9, 9]}]\n"
      "    handle: {xyz: [0, -20, 0], width: 9}\n";
  return With(With(kTable, "PIECE", kBox),
              "density:", "fixed: true\n    density:") +
         "  cover:\n" + part +
         "    joint: {on: cube, xyz: [0, 0, 50], kind: hinge, axis: [2, 0, 0],"
         " at: [0, 10, 0], limits_deg: [0, 90], friction: 1, damping: 2}\n"
         "  box:\n" +
         part +
         "    joint: {on: cube, xyz: [0, 0, 20], rpy: [0, 0, 90], kind: slide,"
         " axis: [0, 1, 0], limits_mm: [-5, 40], friction: 3, damping: 4}\n";
}

TEST(PartTable, AnArticulatedPartHasAJointAndAHandle) {
  const PartTable table = Load(Articulated());
  const Part& cover = *table.Find("cover");
  ASSERT_TRUE(cover.joint);
  EXPECT_FALSE(cover.is_free());
  EXPECT_EQ(cover.grasps.size(), 1u);
  EXPECT_EQ(cover.joint->kind, PartJoint::Kind::kHinge);
  EXPECT_EQ(cover.joint->host, "cube");
  EXPECT_NEAR(cover.joint->upper, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(cover.joint->axis.x(), 1, 1e-12);
  EXPECT_NEAR(cover.joint->LeverAt(cover.grasps[0].X_OG.translation()), 0.03,
              1e-12);
  const PartJoint& slide = *table.Find("box")->joint;
  EXPECT_EQ(slide.kind, PartJoint::Kind::kSlide);
  EXPECT_NEAR(slide.lower, -0.005, 1e-12);
  EXPECT_EQ(slide.friction, 3);
  EXPECT_EQ(slide.damping, 4);
}

// Property: a hinge leaves its axis where it is, a slide every direction.
TEST(PartJoint, TurnsAboutItsAxisOrSlidesAlongIt) {
  const PartTable table = Load(Articulated());
  const PartJoint& hinge = *table.Find("cover")->joint;
  const PartJoint& slide = *table.Find("box")->joint;
  for (const double position : {-1.0, 0.0, 1e-9, 0.3, 2.0}) {
    const Eigen::Isometry3d X = hinge.Displacement(position);
    EXPECT_TRUE((X * hinge.p_OA).isApprox(hinge.p_OA, 1e-12));
    EXPECT_NEAR(Eigen::AngleAxisd(X.linear()).angle(), std::abs(position),
                1e-9);
    EXPECT_TRUE(slide.Displacement(position).translation().isApprox(
        position * Eigen::Vector3d::UnitY()));
    EXPECT_TRUE(slide.Displacement(position).linear().isIdentity());
  }
}

TEST(PartTable, RefusesImpossibleJointsByFileAndKey) {
  using testing::StartsWith;
  const std::string good = Articulated();
  ASSERT_EQ(ErrorOf(good), "");
  const auto error = [&](const std::string& what, const std::string& by) {
    return ErrorOf(With(good, what, by));
  };
  EXPECT_THAT(error(" limits_deg: [0, 90],", ""),
              StartsWith("parts.yaml:parts.cover.joint: a hinge needs "
                         "limits_deg: [lower, upper]"));
  EXPECT_THAT(error(" limits_mm: [-5, 40],", " limits_deg: [-5, 40],"),
              StartsWith("parts.yaml:parts.box.joint: a slide needs "
                         "limits_mm: [lower, upper]"));
  EXPECT_THAT(error("[0, 90]", "[90, 0]"),
              StartsWith("parts.yaml:parts.cover.joint.limits_deg: should be "
                         "[lower, upper], ascending"));
  EXPECT_THAT(
      error("[0, 90]", "[10, 90]"),
      StartsWith("parts.yaml:parts.cover.joint.limits_deg: should contain "
                 "0"));
  EXPECT_THAT(error("kind: hinge", "kind: ball"),
              StartsWith("parts.yaml:parts.cover.joint.kind: 'ball' is neither "
                         "hinge nor slide"));
  EXPECT_THAT(error("on: cube", "on: box"),
              StartsWith("parts.yaml:parts.cover.joint.on: 'box' is not a "
                         "fixed part; fixed parts: cube"));
  EXPECT_THAT(error("axis: [2, 0, 0]", "axis: [0, 0, 0]"),
              StartsWith("parts.yaml:parts.cover.joint.axis"));
  EXPECT_THAT(error("    handle: {xyz: [0, -20, 0], width: 9}\n", ""),
              StartsWith("parts.yaml:parts.cover: an articulated part needs a "
                         "handle"));
  EXPECT_THAT(error("xyz: [0, -20, 0]", "xyz: [5, 10, 0]"),
              StartsWith("parts.yaml:parts.cover.handle: lies on the axis"));
  EXPECT_THAT(error("    joint: {on: cube, xyz: [0, 0, 50]",
                    "    fixed: true\n    joint: {on: cube, xyz: [0, 0, 50]"),
              StartsWith("parts.yaml:parts.cover.joint: a fixed part"));
  EXPECT_THAT(error(" friction: 1,", ""),
              StartsWith("parts.yaml:parts.cover.joint.friction: missing"));
}

TEST(PartTable, RefusesAnOutlineThatIsNotConvexOrRunsClockwise) {
  const std::string prism = "prism, z: [0, 10], outline: ";
  EXPECT_EQ(ErrorOf(With(kTable, "PIECE",
                         prism + "[[0, 0], [10, 0], [10, 10], [0, 10]]")),
            "");
  EXPECT_THAT(ErrorOf(With(kTable, "PIECE",
                           prism + "[[0, 0], [10, 0], [2, 2], [0, 10]]")),
              testing::HasSubstr("parts.cube.pieces[0]: not convex"));
  EXPECT_NE(ErrorOf(With(kTable, "PIECE",
                         prism + "[[0, 10], [10, 10], [10, 0], [0, 0]]")),
            "");
}

// Property: the wedges of a hole fill its block and leave the hole open.
TEST(PartTable, WedgesOfAHoleTileTheirBlock) {
  for (const int sides : {4, 8, 16, 48}) {
    const Part part = WithPiece(
        "hole, center: [10, 20], z: [0, 30], apothem: 16, outer: 24, "
        "rotation: 30, chamfer: [0, 0], sides: " +
        std::to_string(sides));
    ASSERT_EQ(part.pieces.size(), static_cast<size_t>(sides));
    const double polygon =
        sides * 0.016 * 0.016 * std::tan(std::numbers::pi / sides);
    const VolumeMoments moments = MomentsOf(part.pieces);
    EXPECT_NEAR(moments.volume, 0.03 * (0.048 * 0.048 - polygon), 1e-12);
    EXPECT_NEAR((moments.centre - Eigen::Vector3d(0.010, 0.020, 0.015)).norm(),
                0, 1e-9);
  }
}

TEST(PartTable, ChamfersTakeTheirVolumeOnBothFaces) {
  const std::string hole =
      "hole, center: [0, 0], z: [0, 30], apothem: 16, outer: 24, sides: 4, ";
  const double sharp =
      MomentsOf(WithPiece(hole + "chamfer: [0, 0]").pieces).volume;
  const double both =
      MomentsOf(WithPiece(hole + "chamfer: [3, 3]").pieces).volume;
  // Each frustum between half-widths a and a + c holds c (4a^2 + 4ac + 4c^2/3).
  const double a = 0.016, c = 0.003;
  const double frustum = c * (4 * a * a + 4 * a * c + 4 * c * c / 3);
  EXPECT_NEAR(sharp - both, 2 * (frustum - c * 4 * a * a), 1e-12);
}

TEST(Piece, MirrorImageHasTheSameMomentsAtMinusX) {
  const Part part = WithPiece(
      "prism, z: [0, 10], outline: [[5, 0], [25, 0], [30, 20], [5, 10]]");
  const Piece mirrored = MirroredInX(part.pieces[0]);
  EXPECT_EQ(WhyNotConvex(mirrored), "");
  const VolumeMoments a = MomentsOf(part.pieces), b = MomentsOf({mirrored});
  EXPECT_NEAR(a.volume, b.volume, 1e-15);
  EXPECT_NEAR(a.centre.x(), -b.centre.x(), 1e-12);
  EXPECT_NEAR(a.inertia(0, 1), -b.inertia(0, 1), 1e-15);
}

TEST(Piece, MomentsOfABoxAreTheTextbooks) {
  const VolumeMoments m = MomentsOf(WithPiece(kBox).pieces);
  EXPECT_NEAR(m.volume, 0.05 * 0.05 * 0.05, 1e-12);
  EXPECT_NEAR(m.inertia(2, 2), m.volume * 0.05 * 0.05 / 6, 1e-15);
}

TEST(CellLayout, LoadsTheShippedTask) {
  const CellLayout layout = CellLayout::FromConfig(
      Config::Load(CELL_SOURCE_DIR "/deploy/tasks/cranfield/cell.yaml"));
  EXPECT_EQ(layout.hands.size(), 2u);
  EXPECT_NEAR(layout.pedestal.X_WP.translation().z(), 0.14, 1e-12);
}

TEST(PartTable, LoadsTheShippedTask) {
  const PartTable table = PartTable::FromConfig(
      Config::Load(CELL_SOURCE_DIR "/deploy/tasks/cranfield/parts.yaml"));
  EXPECT_EQ(table.parts().size(), 10u);
  for (const char* site :
       {"base.round_1", "base.round_2", "base.square_1", "base.square_2",
        "base.shaft", "base.separator", "base.pendulum", "base.face_plate",
        "pendulum.head"}) {
    EXPECT_NE(table.FindSite(site), nullptr) << site;
  }
  // The stud's axis is y of its part.
  const Eigen::Vector3d z =
      table.FindSite("pendulum.head")->X_HS.linear().col(2);
  EXPECT_NEAR((z - Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  // Solid pieces do not overlap beyond the hub's rounding.
  for (const Part& part : table.parts()) {
    const double mass = part.density * MomentsOf(part.pieces).volume;
    EXPECT_GT(mass, 0.05) << part.name;
    EXPECT_LT(mass, 1.5) << part.name;
  }
}

}  // namespace
}  // namespace cell
