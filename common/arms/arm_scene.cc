#include "common/arms/arm_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "common/geometry/part_shape.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr char kTable[] = "table";
constexpr char kPedestal[] = "pedestal";
constexpr double kMinClearance = 1e-4;    // [m] what counts as touching
constexpr double kGraspedWithin = 0.015;  // [m] of every finger

// "gripper_right" of "gripper_right.palm".
std::string OwnerOf(const std::string& body) {
  return body.substr(0, body.find('.'));
}

}  // namespace

struct ArmScene::Solid {
  explicit Solid(const Part& part)
      : name(part.name),
        owner(OwnerOf(part.name)),
        shape(part),
        centre(shape.box().center()),
        radius(shape.box().diagonal().norm() / 2) {}

  bool IsCalled(const std::string& called) const {
    return called == name || called == owner;
  }

  std::string name;
  std::string owner;
  PartShape shape;
  Vector3d centre;  // of the sphere that holds it
  double radius;
};

struct ArmScene::Shapes {
  Shapes(const PartTable& table, const CellLayout& cell_layout)
      : parts(table),
        layout(cell_layout),
        pedestal(PedestalBody(layout.pedestal)) {
    for (const Part& part : parts.parts()) part_solids.emplace_back(part);
    for (const ArmLayout& arm : layout.arms) {
      std::vector<Solid>& solids = arm_solids.emplace_back();
      for (const Part& body : BodyPartsOf(arm)) solids.emplace_back(body);
    }
  }

  PartTable parts;
  CellLayout layout;
  Solid pedestal;
  std::vector<Solid> part_solids;
  std::vector<std::vector<Solid>> arm_solids;
};

struct ArmScene::Posed {
  Posed(const Solid& its_solid, const Isometry3d& its_pose)
      : solid(&its_solid), X_WO(its_pose), p_W(X_WO * its_solid.centre) {}

  const Solid* solid;
  Isometry3d X_WO;
  Vector3d p_W;  // the middle of its sphere
};

// Finds the first pair that is nearer than the rule wants.
class ArmScene::Query {
 public:
  explicit Query(const ClearanceRule& rule)
      : rule_(rule), clearance_(std::max(rule.clearance, kMinClearance)) {}

  std::optional<BodyPair> AgainstTable(const Posed& body) const {
    if (body.p_W.z() - body.solid->radius >= clearance_ ||
        body.solid->shape.LowestZ(body.X_WO) >= clearance_ ||
        IsAllowed([](const std::string& name) { return name == kTable; },
                  *body.solid)) {
      return std::nullopt;
    }
    return BodyPair{body.solid->name, kTable};
  }

  std::optional<BodyPair> Against(const Posed& body, const Posed& other) const {
    return PairOf(body, other, clearance_);
  }

  std::optional<BodyPair> AgainstOwn(const Posed& body,
                                     const Posed& other) const {
    return PairOf(body, other, std::min(clearance_, kSelfClearance));
  }

 private:
  std::optional<BodyPair> PairOf(const Posed& a, const Posed& b,
                                 double clearance) const {
    const double between = a.solid->radius + b.solid->radius + clearance;
    if ((a.p_W - b.p_W).squaredNorm() >= between * between) return std::nullopt;
    if (!AreNear(a, b, clearance) ||
        IsAllowed(
            [&](const std::string& name) { return a.solid->IsCalled(name); },
            *b.solid)) {
      return std::nullopt;
    }
    return BodyPair{a.solid->name, b.solid->name};
  }

  static bool AreNear(const Posed& a, const Posed& b, double clearance) {
    const auto is_far = [&](const Posed& box, const Posed& sphere) {
      return box.solid->shape.box().exteriorDistance(
                 box.X_WO.inverse(Eigen::Isometry) * sphere.p_W) >=
             sphere.solid->radius + clearance;
    };
    if (is_far(a, b) || is_far(b, a)) return false;
    // Any distance below the clearance ends the search.
    return PartShape::Distance(a.solid->shape, a.X_WO, b.solid->shape, b.X_WO,
                               clearance, clearance * (1 - 1e-6)) < clearance;
  }

  template <class IsFirst>
  bool IsAllowed(const IsFirst& is_first, const Solid& second) const {
    return std::ranges::any_of(rule_.allowed, [&](const auto& pair) {
      return (is_first(pair.first) && second.IsCalled(pair.second)) ||
             (is_first(pair.second) && second.IsCalled(pair.first));
    });
  }

  const ClearanceRule& rule_;
  double clearance_;
};

ArmScene::ArmScene(const PartTable& parts, const CellLayout& layout)
    : shapes_(std::make_shared<const Shapes>(parts, layout)),
      X_WO_(parts.parts().size()) {
  for (size_t i = 0; i < X_WO_.size(); ++i) {
    if (parts.parts()[i].is_fixed) X_WO_[i] = layout.pedestal.X_WP;
  }
  for (const ArmLayout& arm : layout.arms) {
    postures_.push_back(HomePosture(arm));
    X_WB_.push_back(BodyPosesOf(arm, postures_.back()));
  }
  held_.resize(layout.arms.size());
}

void ArmScene::PutPart(const std::string& part, const Isometry3d& X_WO) {
  const size_t index = PartIndex(part);
  for (auto& held : held_) {
    if (held && held->part == part) held.reset();
  }
  X_WO_[index] = X_WO;
}

void ArmScene::RemovePart(const std::string& part) {
  X_WO_[PartIndex(part)].reset();
}

void ArmScene::PutParts(const std::map<std::string, Isometry3d>& X_WO) {
  std::ranges::fill(X_WO_, std::nullopt);
  for (const auto& [part, pose] : X_WO) PutPart(part, pose);
}

void ArmScene::SetPosture(const std::string& arm, const ArmPosture& posture) {
  const size_t index = ArmIndex(arm);
  X_WB_[index] = BodyPosesOf(layout().arms[index], posture);
  postures_[index] = posture;
}

void ArmScene::Hold(const std::string& arm, const std::string& part,
                    const Isometry3d& X_GO) {
  RemovePart(part);
  for (auto& held : held_) {
    if (held && held->part == part) held.reset();
  }
  held_[ArmIndex(arm)] = Held{part, X_GO};
}

void ArmScene::LetGo(const std::string& arm) {
  held_[ArmIndex(arm)].reset();
}

/// The bodies of an arm, then what it holds.
std::vector<ArmScene::Posed> ArmScene::BodiesOf(
    size_t arm, const std::vector<Isometry3d>& X_WB, const Joints& q) const {
  const std::vector<Solid>& solids = shapes_->arm_solids[arm];
  std::vector<Posed> bodies;
  bodies.reserve(solids.size() + 1);
  for (size_t i = 0; i < solids.size(); ++i) {
    bodies.emplace_back(solids[i], X_WB[i]);
  }
  if (const auto& held = held_[arm]) {
    bodies.emplace_back(shapes_->part_solids[PartIndex(held->part)],
                        GripperPose(layout().arms[arm], q) * held->X_GO);
  }
  return bodies;
}

std::vector<ArmScene::Posed> ArmScene::OtherArms(size_t arm) const {
  std::vector<Posed> others;
  for (size_t other = 0; other < postures_.size(); ++other) {
    if (other == arm) continue;
    for (const Posed& body :
         BodiesOf(other, X_WB_[other], postures_[other].q)) {
      others.push_back(body);
    }
  }
  return others;
}

std::vector<ArmScene::Posed> ArmScene::Obstacles(size_t arm) const {
  std::vector<Posed> obstacles = OtherArms(arm);
  for (size_t i = 0; i < X_WO_.size(); ++i) {
    if (X_WO_[i]) obstacles.emplace_back(shapes_->part_solids[i], *X_WO_[i]);
  }
  obstacles.emplace_back(shapes_->pedestal, layout().pedestal.X_WP);
  return obstacles;
}

std::vector<ArmScene::Posed> ArmScene::Moving(size_t arm,
                                              const ArmPosture& posture) const {
  std::vector<Posed> moving =
      BodiesOf(arm, BodyPosesOf(layout().arms[arm], posture), posture.q);
  moving.erase(moving.begin(), moving.begin() + ArmModel::kFirstLinkBody);
  return moving;
}

double ArmScene::Nearest(const std::vector<Posed>& moving,
                         const std::vector<Posed>& others, double cutoff) {
  double nearest = cutoff;
  for (const Posed& own : moving) {
    for (const Posed& other : others) {
      const double between = own.solid->radius + other.solid->radius + nearest;
      if ((own.p_W - other.p_W).squaredNorm() >= between * between) continue;
      nearest = PartShape::Distance(own.solid->shape, own.X_WO,
                                    other.solid->shape, other.X_WO, nearest);
    }
  }
  return nearest;
}

double ArmScene::DistanceToOthers(const std::string& arm,
                                  const ArmPosture& posture,
                                  double cutoff) const {
  const size_t index = ArmIndex(arm);
  return Nearest(Moving(index, posture), OtherArms(index), cutoff);
}

double ArmScene::DistanceTo(const PointCloud& points,
                            const std::vector<std::string>& parts,
                            const std::string& arm, const ArmPosture& posture,
                            double cutoff) const {
  const std::vector<Posed> moving = Moving(ArmIndex(arm), posture);
  double nearest = cutoff;
  for (const Posed& own : moving) {
    nearest = own.solid->shape.DistanceTo(points, own.X_WO, nearest);
  }
  std::vector<Posed> others;
  for (const std::string& part : parts) {
    const size_t i = PartIndex(part);
    if (X_WO_[i]) others.emplace_back(shapes_->part_solids[i], *X_WO_[i]);
  }
  return Nearest(moving, others, nearest);
}

std::optional<std::string> ArmScene::WhyBlocked(
    const std::string& arm, const ArmPosture& posture,
    const ClearanceRule& rule) const {
  const auto pair = FindTooNear(arm, posture, rule);
  if (!pair) return std::nullopt;
  return fmt::format("{} would hit {}{}", pair->first,
                     pair->second == kTable ? "the " : "", pair->second);
}

std::optional<BodyPair> ArmScene::FindTooNear(const std::string& arm,
                                              const ArmPosture& posture,
                                              const ClearanceRule& rule) const {
  const size_t index = ArmIndex(arm);
  const ArmModel& model = *layout().arms[index].model;
  const std::vector<Posed> own =
      BodiesOf(index, BodyPosesOf(layout().arms[index], posture), posture.q);
  const std::vector<Posed> obstacles = Obstacles(index);
  const Query query(rule);
  // The outermost bodies are the most likely to collide.
  for (size_t i = own.size(); i-- > ArmModel::kFirstLinkBody;) {
    if (auto pair = query.AgainstTable(own[i])) return pair;
    for (const Posed& obstacle : obstacles) {
      if (auto pair = query.Against(own[i], obstacle)) return pair;
    }
    // A held part moves with the hand, like the boxes of the hand.
    for (size_t j = 0; j < std::min(i, ArmModel::kNumBodies); ++j) {
      if (!model.MayCollide(j, i)) continue;
      if (auto pair = query.AgainstOwn(own[i], own[j])) return pair;
    }
  }
  return std::nullopt;
}

std::vector<std::string> ArmScene::Neighbours(const std::string& part,
                                              const Isometry3d& X_WO,
                                              double distance) const {
  const PartShape& shape = shapes_->part_solids[PartIndex(part)].shape;
  const auto is_near = [&](const PartShape& other, const Isometry3d& X_WP) {
    return PartShape::Distance(shape, X_WO, other, X_WP, distance) < distance;
  };
  std::vector<std::string> names;
  for (size_t i = 0; i < X_WO_.size(); ++i) {
    const Solid& other = shapes_->part_solids[i];
    if (other.name != part && X_WO_[i] && is_near(other.shape, *X_WO_[i])) {
      names.push_back(other.name);
    }
  }
  if (is_near(shapes_->pedestal.shape, layout().pedestal.X_WP)) {
    names.emplace_back(kPedestal);
  }
  if (shape.LowestZ(X_WO) < distance) names.emplace_back(kTable);
  return names;
}

std::optional<std::string> ArmScene::FindGrasped(
    const std::string& arm, const ArmPosture& posture) const {
  const size_t index = ArmIndex(arm);
  const ArmLayout& its_layout = layout().arms[index];
  const std::vector<Isometry3d> X_WB = BodyPosesOf(its_layout, posture);
  const auto& places = its_layout.hand.FindGrip(posture.grip)->places;
  const auto farthest_finger = [&](size_t part) {
    double farthest = 0;
    for (size_t i = 0; i < places.size(); ++i) {
      if (!HandType::IsFinger(places[i])) continue;
      const size_t body = ArmModel::kNumBodies + i;
      farthest = std::max(
          farthest,
          PartShape::Distance(shapes_->arm_solids[index][body].shape,
                              X_WB[body], shapes_->part_solids[part].shape,
                              *X_WO_[part], kGraspedWithin));
    }
    return farthest;
  };
  double nearest = kGraspedWithin;
  std::optional<std::string> grasped;
  for (size_t i = 0; i < X_WO_.size(); ++i) {
    if (!X_WO_[i] || parts().parts()[i].is_fixed) continue;
    const double farthest = farthest_finger(i);
    if (farthest >= nearest) continue;
    nearest = farthest;
    grasped = parts().parts()[i].name;
  }
  return grasped;
}

const ArmPosture& ArmScene::PostureOf(const std::string& arm) const {
  return postures_[ArmIndex(arm)];
}

std::optional<Isometry3d> ArmScene::PoseOf(const std::string& part) const {
  return X_WO_[PartIndex(part)];
}

std::optional<ArmScene::Held> ArmScene::HeldBy(const std::string& arm) const {
  return held_[ArmIndex(arm)];
}

const CellLayout& ArmScene::layout() const {
  return shapes_->layout;
}

const PartTable& ArmScene::parts() const {
  return shapes_->parts;
}

size_t ArmScene::ArmIndex(const std::string& arm) const {
  const auto& arms = shapes_->layout.arms;
  for (size_t i = 0; i < arms.size(); ++i) {
    if (arms[i].name == arm) return i;
  }
  throw std::invalid_argument(fmt::format("there is no arm '{}'", arm));
}

size_t ArmScene::PartIndex(const std::string& part) const {
  const auto& solids = shapes_->part_solids;
  for (size_t i = 0; i < solids.size(); ++i) {
    if (solids[i].name == part) return i;
  }
  throw std::invalid_argument(fmt::format("there is no part '{}'", part));
}

}  // namespace cell
