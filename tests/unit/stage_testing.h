#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "common/actions/sec_models.h"
#include "common/config/deployment.h"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/predicates/predicate_sensor.h"
#include "common/relational/domain.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"
#include "common/task/task.h"
#include "services/tracker/ideal_tracker.h"

namespace cell {

using namespace tracker;

/// The shipped task, for tests.
inline Deployment ShippedDeployment() {
  const std::filesystem::path source = CELL_SOURCE_DIR;
  return {source / "deploy/config", source / "deploy/tasks/cranfield"};
}

struct ShippedTask : Task {
  ShippedTask() : Task(LoadTask(ShippedDeployment())) {}

  /// Of the models that the task comes with.
  std::shared_ptr<const SecLibrary> MakeLibrary() const {
    return MakeSecLibrary({domain, parts, actions});
  }
};

/// Adds the boxes of a hand that grips with its fingers down X_WG.
inline void AddHand(const HandType& type, const std::string& hand,
                    const Eigen::Isometry3d& X_WG, double opening,
                    TruthPoses& truth) {
  for (size_t i = 0; i < type.boxes.size(); ++i) {
    truth.poses[hand + "." + type.boxes[i].name] =
        X_WG * HandType::PlaceOf(type.grips[0], i, opening);
  }
}

/// Puts parts and hands where a test wants them, and makes key frames of it.
/// At first the base stands on its pedestal and everything else upright on the
/// table, in rows; no hand touches anything.
class Stage {
 public:
  explicit Stage(const ShippedTask& task) : task_(task) {
    constexpr double kLeft = -0.38, kRight = 0.5, kGap = 0.04;
    double x = kLeft, y = -0.58;
    for (const Part& part : task_.parts.parts()) {
      const PartShape& shape =
          shapes_.emplace(part.name, PartShape(part)).first->second;
      if (part.is_fixed) {
        poses_[part.name] = task_.layout.pedestal.X_WP;
        continue;
      }
      const double width = shape.box().sizes().x();
      if (x + width > kRight) {
        x = kLeft;
        y += 0.38;
      }
      StandAt(part.name, x + width / 2, y);
      x += width + kGap;
    }
  }

  void Put(const std::string& part, const Eigen::Isometry3d& X_WO) {
    poses_[part] = X_WO;
  }
  void StandAt(const std::string& part, double x, double y) {
    Rest(part, x, y, Eigen::Matrix3d::Identity());
  }
  void LieAt(const std::string& part, double x, double y) {
    Rest(part, x, y,
         Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX())
             .toRotationMatrix());
  }
  /// Every part at one of its sites.
  void SeatAll() {
    for (const auto& [part, site] : {std::pair{"shaft", "base.shaft"},
                                     {"round_peg_1", "base.round_1"},
                                     {"round_peg_2", "base.round_2"},
                                     {"square_peg_1", "base.square_1"},
                                     {"square_peg_2", "base.square_2"},
                                     {"pendulum", "base.pendulum"},
                                     {"separator", "base.separator"},
                                     {"head", "pendulum.head"},
                                     {"face_plate", "base.face_plate"}}) {
      Seat(part, site);
    }
  }
  /// At the site, off by X_SO.
  void Seat(const std::string& part, const std::string& site,
            const Eigen::Isometry3d& X_SO = Eigen::Isometry3d::Identity()) {
    const Site* s = task_.parts.FindSite(site);
    poses_[part] = poses_.at(s->host) * s->X_HS * X_SO;
  }
  void Lift(const std::string& part, double height) {
    poses_[part].translation().z() += height;
  }
  void Remove(const std::string& part) { poses_.erase(part); }
  void Hold(const std::string& hand, const std::string& part) {
    held_.insert({hand, part});
  }
  void LetGo(const std::string& hand, const std::string& part) {
    held_.erase({hand, part});
  }
  /// The right hand takes the part and lifts it, move() puts it somewhere, and
  /// the hand lets go; see(key frame) is called before, after and in between.
  template <class Move, class See>
  void Manipulate(const std::string& part, Move move, See see) {
    see(Frame());
    Hold("hand_right", part);
    see(Frame());
    Lift(part, 0.2);
    see(Frame());
    move();
    see(Frame());
    LetGo("hand_right", part);
    see(Frame());
  }
  const Eigen::Isometry3d& PoseOf(const std::string& part) const {
    return poses_.at(part);
  }

  /// The next key frame, half a second after the last.
  KeyFrame Frame() {
    KeyFrame frame{500'000 * next_index_, next_index_, {}, poses_};
    ++next_index_;
    const auto& names = task_.scene_objects.names();
    for (size_t i = 0; i < names.size(); ++i) {
      for (size_t j = i + 1; j < names.size(); ++j) {
        frame.relations[{names[i], names[j]}] = RelationOf(names[i], names[j]);
      }
    }
    return frame;
  }

  /// Every part tracked.
  Tracks AllTracked() const {
    Tracks tracks;
    for (const auto& [name, X_WO] : poses_) {
      tracks.tracks.push_back({name, Track::State::kTracked, 1, X_WO, {}});
    }
    return tracks;
  }

 private:
  void Rest(const std::string& part, double x, double y,
            const Eigen::Matrix3d& R_WO) {
    Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
    X_WO.linear() = R_WO;
    X_WO.translation() << x, y, -shapes_.at(part).LowestZ(X_WO);
    poses_[part] = X_WO;
  }

  Relation RelationOf(const std::string& a, const std::string& b) const {
    if (held_.contains({a, b}) || held_.contains({b, a})) {
      return Relation::kTouching;
    }
    const auto pose_a = poses_.find(a), pose_b = poses_.find(b);
    double distance = 1;
    if (pose_a != poses_.end() && pose_b != poses_.end()) {
      distance = PartShape::Distance(shapes_.at(a), pose_a->second,
                                     shapes_.at(b), pose_b->second, 1);
    } else if (a == SceneObjects::kTable && pose_b != poses_.end()) {
      distance = shapes_.at(b).LowestZ(pose_b->second);
    } else if (b == SceneObjects::kTable && pose_a != poses_.end()) {
      distance = shapes_.at(a).LowestZ(pose_a->second);
    }
    return distance < 0.004 ? Relation::kTouching : Relation::kNotTouching;
  }

  const ShippedTask& task_;
  std::map<std::string, PartShape> shapes_;
  std::map<std::string, Eigen::Isometry3d> poses_;
  std::set<std::pair<std::string, std::string>> held_;  // hand, part
  int64_t next_index_ = 0;
};

}  // namespace cell
