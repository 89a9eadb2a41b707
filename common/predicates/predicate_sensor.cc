#include "common/predicates/predicate_sensor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The truth of a predicate while a part is in the way: false only if that part
// is seen now, not if its pose is only the last one seen.
Truth FalseIfSeen(Visibility visibility) {
  return visibility == Visibility::kSeen ? Truth::kFalse : Truth::kUnknown;
}

Truth FromBool(bool value) {
  return value ? Truth::kTrue : Truth::kFalse;
}

bool Fits(const Part& part, const Site& site) {
  return std::find(part.fits.begin(), part.fits.end(), site.type) !=
         part.fits.end();
}

}  // namespace

PredicateSensor::PredicateSensor(const Vocabulary& vocabulary,
                                 const PartTable& parts,
                                 const Eigen::AlignedBox3d& workspace,
                                 std::vector<PredicateGeometry> geometries,
                                 const PoseUncertainty& uncertainty)
    : vocabulary_(vocabulary),
      parts_(parts),
      workspace_(workspace),
      shapes_(ShapesOf(parts)),
      geometries_(std::move(geometries)),
      uncertainty_(uncertainty) {
  for (const Object& object : vocabulary_.objects()) {
    part_of_object_.push_back(IndexOfPart(object.name));
    site_of_object_.push_back(parts_.FindSite(object.name));
  }
}

State PredicateSensor::Sense(const Scene& scene) const {
  if (scene.items.size() != parts_.parts().size()) {
    throw std::invalid_argument("scene of " +
                                std::to_string(scene.items.size()) + " parts");
  }
  View view{scene, std::vector<bool>(scene.items.size(), false)};
  State state(vocabulary_.num_atoms());
  // Seats first: the other predicates depend on them.
  for (const bool of_seats : {true, false}) {
    for (int index = 0; index < state.num_atoms(); ++index) {
      const GroundAtom atom = vocabulary_.Atom(index);
      const bool is_seat = std::holds_alternative<SeatedGeometry>(
          geometries_[Index(atom.predicate)]);
      if (is_seat != of_seats) continue;
      const Truth truth = SenseAtom(atom, view);
      state.Set(index, truth);
      if (is_seat && truth == Truth::kTrue) {
        view.is_seated[PartOf(atom.objects[0])] = true;
      }
    }
  }
  return state;
}

template <>
Truth PredicateSensor::SenseKind(const SeatedGeometry& seated,
                                 const GroundAtom& atom,
                                 const View& view) const {
  const size_t part = PartOf(atom.objects[0]);
  const Site& site = seated.site ? *seated.site : SiteOf(atom.objects[1]);
  if (!Fits(parts_.parts()[part], site)) return Truth::kFalse;
  const size_t host = IndexOfPart(site.host);
  const Scene::Item& item = view.scene.items[part];
  const Scene::Item& host_item = view.scene.items[host];
  if (item.visibility != Visibility::kSeen ||
      host_item.visibility != Visibility::kSeen) {
    return Truth::kUnknown;
  }
  const Isometry3d X_SO = (host_item.X_WO * site.X_HS).inverse() * item.X_WO;
  const bool touches = seated.must_touch_host
                           ? item.touches[host]
                           : std::find(item.touches.begin(), item.touches.end(),
                                       true) != item.touches.end();
  if (!touches) return Truth::kFalse;
  return SeatedTruth(X_SO, parts_.parts()[part].symmetry_order,
                     seated.tolerance, uncertainty_);
}

template <>
Truth PredicateSensor::SenseKind(const TiltedGeometry& tilted,
                                 const GroundAtom& atom,
                                 const View& view) const {
  const Scene::Item& item = view.scene.items[PartOf(atom.objects[0])];
  if (item.visibility != Visibility::kSeen) return Truth::kUnknown;
  const double excess = TiltOf(item.X_WO) - tilted.over;
  if (std::abs(excess) < uncertainty_.rotation) return Truth::kUnknown;
  return FromBool(excess > 0);
}

template <>
Truth PredicateSensor::SenseKind(const GraspableGeometry& graspable,
                                 const GroundAtom& atom,
                                 const View& view) const {
  const size_t part = PartOf(atom.objects[0]);
  if (view.scene.items[part].visibility != Visibility::kSeen)
    return Truth::kUnknown;
  if (view.IsCarried(part)) return Truth::kTrue;
  if (!IsWithinReach(part, view)) return Truth::kFalse;
  Truth truth = Truth::kTrue;
  for (const size_t cover : PartsOver(part, view)) {
    if (!view.scene.items[part].touches[cover] &&
        !CoversGrasps(cover, part, graspable, view)) {
      continue;
    }
    truth = FalseIfSeen(view.scene.items[cover].visibility);
    if (truth == Truth::kFalse) break;
  }
  return truth;
}

template <>
Truth PredicateSensor::SenseKind(const FreeSpaceGeometry& space,
                                 const GroundAtom& atom,
                                 const View& view) const {
  const auto& objects = vocabulary_.ObjectsOf(
      vocabulary_.predicates()[Index(atom.predicate)].argument_types[0]);
  const auto place =
      std::lower_bound(objects.begin(), objects.end(), atom.objects[0]);
  const ClearanceColumn& column =
      space.columns[static_cast<size_t>(place - objects.begin())];
  const Site& site = SiteOf(atom.objects[0]);
  const size_t host = IndexOfPart(site.host);
  if (view.scene.items[host].visibility != Visibility::kSeen)
    return Truth::kUnknown;
  const Isometry3d X_WS = view.scene.items[host].X_WO * site.X_HS;
  Truth truth = Truth::kTrue;
  for (size_t i = 0; i < shapes_.size(); ++i) {
    const Scene::Item& item = view.scene.items[i];
    if (i == host || view.IsCarried(i)) continue;
    const bool may_be_there =
        item.visibility == Visibility::kMissing
            ? Fits(parts_.parts()[i], site)
            : column.IsBlockedBy(shapes_[i], item.X_WO, X_WS);
    if (!may_be_there) continue;
    truth = FalseIfSeen(item.visibility);
    if (truth == Truth::kFalse) break;
  }
  return truth;
}

template <>
Truth PredicateSensor::SenseKind(const ReportedGeometry& /*reported*/,
                                 const GroundAtom& /*atom*/,
                                 const View& /*view*/) const {
  return Truth::kUnknown;
}

Truth PredicateSensor::SenseAtom(const GroundAtom& atom,
                                 const View& view) const {
  return std::visit(
      [&](const auto& geometry) { return SenseKind(geometry, atom, view); },
      geometries_[Index(atom.predicate)]);
}

std::vector<size_t> PredicateSensor::PartsOver(size_t part,
                                               const View& view) const {
  const Isometry3d& X_WO = view.scene.items[part].X_WO;
  const double middle =
      (shapes_[part].LowestZ(X_WO) + shapes_[part].HighestZ(X_WO)) / 2;
  std::vector<size_t> parts;
  for (size_t i = 0; i < shapes_.size(); ++i) {
    const Scene::Item& item = view.scene.items[i];
    if (i == part || item.visibility == Visibility::kMissing ||
        view.IsCarried(i)) {
      continue;
    }
    if (shapes_[i].LowestZ(item.X_WO) > middle) parts.push_back(i);
  }
  return parts;
}

bool PredicateSensor::CoversGrasps(size_t cover, size_t part,
                                   const GraspableGeometry& graspable,
                                   const View& view) const {
  const auto& grasps = parts_.parts()[part].grasps;
  if (grasps.empty()) return false;
  const Isometry3d& X_WO = view.scene.items[part].X_WO;
  const Isometry3d& X_WC = view.scene.items[cover].X_WO;
  const auto is_covered = [&](const Grasp& grasp) {
    for (const double side : {-1., 1.}) {
      const double x = side * (grasp.width / 2 + graspable.finger);
      const Isometry3d X_WTip(
          Eigen::Translation3d(X_WO * (grasp.X_OG * Vector3d(x, 0, 0))));
      if (graspable.column.IsBlockedBy(shapes_[cover], X_WC, X_WTip))
        return true;
    }
    return false;
  };
  return std::all_of(grasps.begin(), grasps.end(), is_covered);
}

bool PredicateSensor::IsWithinReach(size_t part, const View& view) const {
  return workspace_.contains(view.scene.items[part].X_WO.translation());
}

size_t PredicateSensor::IndexOfPart(const std::string& name) const {
  const auto& parts = parts_.parts();
  return static_cast<size_t>(
      std::find_if(parts.begin(), parts.end(),
                   [&](const Part& part) { return part.name == name; }) -
      parts.begin());
}

}  // namespace cell
