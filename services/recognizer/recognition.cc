#include "services/recognizer/recognition.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/degree.h"
#include "common/predicates/seat.h"
#include "common/scene/scene.h"

namespace cell::recognizer {

using Eigen::Isometry3d;

Recognition::Params Recognition::Params::Load(const Config& config) {
  return {.moved = config.Number("moved_mm", 0, 1000) * 1e-3,
          .turned = config.Number("turned_deg", 0, 180) * kDegree};
}

Recognition::Recognition(const SceneObjects& scene_objects,
                         const PartTable& parts,
                         std::shared_ptr<const SecLibrary> library,
                         std::shared_ptr<const PredicateSensor> sensor,
                         const Params& params)
    : scene_objects_(scene_objects),
      parts_(parts),
      library_(std::move(library)),
      sensor_(std::move(sensor)),
      params_(params) {}

std::vector<RecognisedAction> Recognition::Update(const KeyFrame& frame) {
  const auto now = std::make_shared<const SensedFrame>(
      SensedFrame{frame, sensor_->Sense(SceneOf(frame, scene_objects_))});
  std::vector<Manipulation> placed;
  UpdateHeld(now, placed);
  std::vector<RecognisedAction> actions;
  std::vector<Manipulation> unnamed;
  for (Manipulation& manipulation : placed) {
    const auto completed = manipulation.CompletedBy(*now);
    std::vector<RecognisedAction> named;
    for (const Manipulation::Reading& reading : completed) {
      named.push_back(Report(manipulation, &reading, *now));
    }
    if (!named.empty()) Observe(manipulation, named, *now);
    std::ranges::move(named, std::back_inserter(actions));
    if (completed.empty() && WasMoved(manipulation, *now)) {
      unnamed.push_back(std::move(manipulation));
    }
  }
  for (size_t i = 0; i < unnamed.size(); ++i) {
    const bool carried_by_another =
        std::any_of(unnamed.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    unnamed.end(), [&](const Manipulation& other) {
                      return Rode(unnamed[i].part(), other.part(),
                                  unnamed[i].before(), *now);
                    });
    if (carried_by_another || WasCarriedAlong(unnamed[i], *now)) continue;
    actions.push_back(Report(unnamed[i], nullptr, *now));
    Observe(unnamed[i], {actions.back()}, *now);
  }
  previous_ = now;
  return actions;
}

std::vector<std::string> Recognition::HandsOn(const std::string& part,
                                              const TouchGraph& graph) const {
  std::vector<std::string> hands;
  for (const std::string& hand : scene_objects_.hands()) {
    if (Touch(graph, part, hand)) hands.push_back(hand);
  }
  return hands;
}

// Orders the placed parts: one that was picked up later, or lies higher, may
// have been carried, and comes before the one that may have carried it.
void Recognition::UpdateHeld(const std::shared_ptr<const SensedFrame>& now,
                             std::vector<Manipulation>& placed) {
  const KeyFrame& frame = now->frame;
  for (const std::string& part : scene_objects_.parts()) {
    const auto hands = HandsOn(part, frame.relations);
    auto it = manipulations_.find(part);
    if (it == manipulations_.end() && !hands.empty()) {
      it = manipulations_
               .emplace(part,
                        Manipulation(*library_, {part, frame.index, frame.utime,
                                                 previous_ ? previous_ : now}))
               .first;
    }
    if (it == manipulations_.end()) continue;
    for (const std::string& hand : hands) it->second.AddHand(hand);
    if (now->frame.index > it->second.before().frame.index) {
      it->second.Append(frame.relations);
    }
    if (!hands.empty()) continue;
    placed.push_back(std::move(it->second));
    manipulations_.erase(it);
  }
  const auto height = [&](const Manipulation& manipulation) {
    const auto pose = frame.poses.find(manipulation.part());
    return pose == frame.poses.end() ? 0 : pose->second.translation().z();
  };
  std::stable_sort(placed.begin(), placed.end(),
                   [&](const Manipulation& a, const Manipulation& b) {
                     if (a.pick_index() != b.pick_index()) {
                       return a.pick_index() > b.pick_index();
                     }
                     return height(a) > height(b);
                   });
}

bool Recognition::WasMoved(const Manipulation& manipulation,
                           const SensedFrame& after) const {
  const auto& poses = manipulation.before().frame.poses;
  const auto from = poses.find(manipulation.part());
  const auto to = after.frame.poses.find(manipulation.part());
  if (from == poses.end() || to == after.frame.poses.end()) return false;
  const Isometry3d X_from_to = from->second.inverse() * to->second;
  const Part* part = parts_.Find(manipulation.part());
  return X_from_to.translation().norm() > params_.moved ||
         VisibleAngle(X_from_to, part->symmetry_order) > params_.turned;
}

bool Recognition::WasCarriedAlong(const Manipulation& manipulation,
                                  const SensedFrame& after) const {
  return std::any_of(
      scene_objects_.parts().begin(), scene_objects_.parts().end(),
      [&](const std::string& other) {
        return other != manipulation.part() &&
               WasHeldSince(other, manipulation.pick_index()) &&
               Rode(manipulation.part(), other, manipulation.before(), after);
      });
}

bool Recognition::WasHeldSince(const std::string& part, int64_t index) const {
  const auto placed = last_placed_.find(part);
  return manipulations_.contains(part) ||
         (placed != last_placed_.end() && placed->second >= index);
}

// It touched the carrier before and after, and lies on it as it did.
bool Recognition::Rode(const std::string& part, const std::string& carrier,
                       const SensedFrame& before,
                       const SensedFrame& after) const {
  Isometry3d X_CP[2];
  for (const SensedFrame* sensed : {&before, &after}) {
    const auto& poses = sensed->frame.poses;
    const auto of_part = poses.find(part);
    const auto of_carrier = poses.find(carrier);
    if (of_part == poses.end() || of_carrier == poses.end() ||
        !Touch(sensed->frame.relations, part, carrier)) {
      return false;
    }
    X_CP[sensed == &after] = of_carrier->second.inverse() * of_part->second;
  }
  const Isometry3d change = X_CP[0].inverse() * X_CP[1];
  return change.translation().norm() <= params_.moved &&
         VisibleAngle(change, parts_.Find(part)->symmetry_order) <=
             params_.turned;
}

void Recognition::Observe(const Manipulation& manipulation,
                          const std::vector<RecognisedAction>& actions,
                          const SensedFrame& after) const {
  if (!observer_) return;
  observer_(
      {manipulation.part(), manipulation.before(), after, manipulation.chain()},
      actions);
}

RecognisedAction Recognition::Report(const Manipulation& manipulation,
                                     const Manipulation::Reading* reading,
                                     const SensedFrame& after) {
  last_placed_[manipulation.part()] = after.frame.index;
  RecognisedAction action;
  if (reading) {
    action.direction = reading->hypothesis.direction;
    action.name = reading->hypothesis.model->action();
    action.arguments = reading->hypothesis.roles;
    action.has_stand_in =
        reading->hypothesis.model->HasStandIn(action.arguments);
    action.confidence = reading->confidence;
  } else {
    action.confidence = manipulation.ConfidenceInNone(after);
  }
  action.part = manipulation.part();
  action.hands.assign(manipulation.hands().begin(), manipulation.hands().end());
  action.pick_utime = manipulation.pick_utime();
  action.pick_key_frame = manipulation.pick_index();
  action.place_utime = after.frame.utime;
  action.place_key_frame = after.frame.index;
  return action;
}

}  // namespace cell::recognizer
