#include "services/vtb/sleeping_bodies.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "services/vtb/hand_sweeps.h"

namespace cell::vtb {
namespace {

using Eigen::Map;
using Eigen::Vector3d;

/// A part sleeps after no point of it has moved further than kStillDistance [m]
/// in kTimeToSleep [s]. Parts at rest in the seats of an assembly drift by 0.5
/// um in that time.
constexpr double kStillDistance = 5e-6, kTimeToSleep = 0.2;
/// A part wakes when a hand that moves, or another part, comes closer than this
/// [m], or would within kHorizon [s]. In a step of 1 ms nothing gets that far.
constexpr double kHandMargin = 0.005, kPartMargin = 0.0005, kHorizon = 0.02;
/// A hand that moves less [m] in a Run() does not move.
constexpr double kCreep = 1e-8;
/// Steps until a group that was kept awake tries again.
constexpr int kRetrySteps = 8;

/// By how much a point within `reach` [m] of the part's origin moves at most,
/// per unit of the joint's position.
double LeverBound(const PartJoint& joint, double reach) {
  return joint.kind == PartJoint::Kind::kSlide ? 1 : reach + joint.p_OA.norm();
}

}  // namespace

SleepingBodies::SleepingBodies(const PartTable& table, const CellLayout& layout,
                               const PartBodies& bodies, const Hands& hands,
                               mjModel& model, mjData& data, bool is_enabled)
    : table_(table),
      layout_(layout),
      bodies_(bodies),
      hands_(hands),
      model_(model),
      data_(data),
      is_enabled_(is_enabled),
      steps_to_sleep_(
          static_cast<int>(std::ceil(kTimeToSleep / model.opt.timestep))),
      types_(model.geom_contype, model.geom_contype + model.ngeom),
      affinities_(model.geom_conaffinity, model.geom_conaffinity + model.ngeom),
      memory_(table.parts().size()) {
  std::vector<int> part_of_body(static_cast<size_t>(model.nbody), -1);
  for (size_t part = 0; part < memory_.size(); ++part) {
    bounds_.emplace_back(model, bodies[part].id);
    if (!IsMovable(part)) continue;
    part_of_body[static_cast<size_t>(bodies[part].id)] = static_cast<int>(part);
  }
  for (int i = 0; i < model.neq; ++i) {
    const int first = part_of_body[static_cast<size_t>(model.eq_obj1id[i])];
    const int second = part_of_body[static_cast<size_t>(model.eq_obj2id[i])];
    if (first < 0 || second < 0) continue;
    links_.push_back(
        {i, static_cast<size_t>(first), static_cast<size_t>(second)});
  }
}

void SleepingBodies::Reset() {
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (IsAsleep(part)) SetCollides(part, true);
    memory_[part] = {};
  }
  approaches_.clear();
}

bool SleepingBodies::AreAllAsleep() const {
  if (!is_enabled_) return false;
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (IsMovable(part) && !IsAsleep(part)) return false;
  }
  return true;
}

void SleepingBodies::SetCollides(size_t part, bool collides) {
  const int body = bodies_[part].id;
  const int begin = model_.body_geomadr[body];
  for (int geom = begin; geom < begin + model_.body_geomnum[body]; ++geom) {
    const auto i = static_cast<size_t>(geom);
    model_.geom_contype[geom] = collides ? types_[i] : 0;
    model_.geom_conaffinity[geom] = collides ? affinities_[i] : 0;
  }
}

void SleepingBodies::Wake(size_t part) {
  memory_[part].num_still = 0;
  const int group = memory_[part].group;
  if (group < 0) return;
  for (size_t i = 0; i < memory_.size(); ++i) {
    if (memory_[i].group != group) continue;
    SetCollides(i, true);
    // While asleep it has the acceleration of a fall: a bad warm start.
    std::fill_n(data_.qacc_warmstart + bodies_[i].dof, bodies_[i].num_dofs,
                mjtNum{0});
    memory_[i] = {};
  }
}

void SleepingBodies::BeforeRun(double duration) {
  if (!is_enabled_) return;
  approaches_.clear();
  for (const HandSweep& sweep : SweepsOf(layout_, hands_)) {
    if (sweep.travel <= kCreep) continue;
    const double speed = sweep.travel / duration;
    approaches_.push_back(
        {sweep.box, kHandMargin + sweep.travel + speed * kHorizon});
  }
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (IsAsleep(part) && IsNearHand(part)) Wake(part);
  }
}

bool SleepingBodies::IsNearHand(size_t part) const {
  const Eigen::Isometry3d X_WO = bodies_.PoseOf(part, data_);
  return std::ranges::any_of(approaches_, [&](const Approach& approach) {
    return bounds_[part].MayBeWithin(approach.distance, X_WO, approach.box);
  });
}

void SleepingBodies::BeforeStep() {
  if (!is_enabled_) return;
  std::vector<size_t> awake;
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (!IsMovable(part)) continue;
    if (hands_.IsHeld(static_cast<int>(part))) Wake(part);
    if (!IsAsleep(part)) awake.push_back(part);
  }
  // Those that it wakes may wake others.
  for (size_t i = 0; i < awake.size(); ++i) {
    for (size_t part = 0; part < memory_.size(); ++part) {
      if (!IsAsleep(part) || !AreNear(part, awake[i])) continue;
      const int group = memory_[part].group;
      for (size_t other = 0; other < memory_.size(); ++other) {
        if (memory_[other].group == group) awake.push_back(other);
      }
      Wake(part);
    }
  }
}

/// True if they touch, are near, or might be so soon.
bool SleepingBodies::AreNear(size_t part, size_t other) const {
  const double speed = std::max(SpeedBound(part), SpeedBound(other));
  return bounds_[part].MayCollideWithin(
      kPartMargin + speed * kHorizon, bodies_.PoseOf(part, data_),
      bounds_[other], bodies_.PoseOf(other, data_));
}

void SleepingBodies::AfterStep() {
  if (!is_enabled_) return;
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (!IsMovable(part)) continue;
    if (IsAsleep(part)) {
      Hold(part);
    } else {
      CountStillSteps(part);
    }
  }
  for (size_t part = 0; part < memory_.size(); ++part) {
    const int num_late = memory_[part].num_still - steps_to_sleep_;
    if (!IsAsleep(part) && num_late >= 0 && num_late % kRetrySteps == 0) {
      TryToSleep(part);
    }
  }
}

void SleepingBodies::Hold(size_t part) {
  const PartBodies::Body& body = bodies_[part];
  std::copy_n(memory_[part].qpos.begin(), body.num_positions,
              data_.qpos + body.qpos);
  std::fill_n(data_.qvel + body.dof, body.num_dofs, mjtNum{0});
}

/// Counts the steps in which it has been still.
void SleepingBodies::CountStillSteps(size_t part) {
  Memory& memory = memory_[part];
  if (hands_.IsHeld(static_cast<int>(part))) {
    memory.num_still = 0;
  } else if (memory.num_still > 0 && DisplacementOf(part) <= kStillDistance) {
    ++memory.num_still;
  } else {
    memory.num_still = 1;
    std::copy_n(data_.qpos + bodies_[part].qpos, bodies_[part].num_positions,
                memory.qpos.begin());
  }
}

/// [m] Of no point of it more, from where it was when it came to rest.
double SleepingBodies::DisplacementOf(size_t part) const {
  const mjtNum* before = memory_[part].qpos.data();
  const mjtNum* now = data_.qpos + bodies_[part].qpos;
  const double reach = bounds_[part].reach();
  if (const auto& joint = table_.parts()[part].joint) {
    return std::abs(now[0] - before[0]) * LeverBound(*joint, reach);
  }
  const Map<const Vector3d> p_before(before), p_now(now);
  const Map<const Eigen::Vector4d> q_before(before + 3), q_now(now + 3);
  // Of unit quaternions: half the angle.
  const double angle = 2 * (q_now - q_before).norm();
  return (p_now - p_before).norm() + angle * reach;
}

/// [m/s] Of no point of it more.
double SleepingBodies::SpeedBound(size_t part) const {
  const mjtNum* v = data_.qvel + bodies_[part].dof;
  const double reach = bounds_[part].reach();
  if (const auto& joint = table_.parts()[part].joint) {
    return std::abs(v[0]) * LeverBound(*joint, reach);
  }
  return Map<const Vector3d>(v).norm() +
         Map<const Vector3d>(v + 3).norm() * reach;
}

/// With all that it could touch, and all that these could touch, if all of
/// them are still.
void SleepingBodies::TryToSleep(size_t part) {
  std::vector<size_t> group{part};
  const auto add = [&](size_t other) {
    if (std::ranges::find(group, other) == group.end()) group.push_back(other);
  };
  for (size_t i = 0; i < group.size(); ++i) {
    if (memory_[group[i]].num_still < steps_to_sleep_ || IsNearHand(group[i])) {
      return;
    }
    for (size_t other = 0; other < memory_.size(); ++other) {
      if (IsMovable(other) && !IsAsleep(other) && AreNear(group[i], other)) {
        add(other);
      }
    }
    for (const Link& link : links_) {
      if (model_.eq_active[link.equality] == 0) continue;
      if (link.first == group[i]) add(link.second);
      if (link.second == group[i]) add(link.first);
    }
  }
  Sleep(group);
}

void SleepingBodies::Sleep(const std::vector<size_t>& group) {
  const size_t first = std::ranges::min(group);
  std::vector<BodyContact>& contacts = memory_[first].contacts;
  for (BodyContact& contact : ContactsOf(model_, data_)) {
    const bool is_of_group = std::ranges::any_of(group, [&](size_t part) {
      const std::string& name = table_.parts()[part].name;
      return contact.first == name || contact.second == name;
    });
    if (is_of_group) contacts.push_back(std::move(contact));
  }
  for (const size_t part : group) {
    Memory& memory = memory_[part];
    memory.group = static_cast<int>(first);
    std::copy_n(data_.qpos + bodies_[part].qpos, bodies_[part].num_positions,
                memory.qpos.begin());
    SetCollides(part, false);
    Hold(part);
  }
}

std::vector<BodyContact> SleepingBodies::Contacts() const {
  std::vector<BodyContact> contacts = ContactsOf(model_, data_);
  std::erase_if(contacts, [&](const BodyContact& contact) {
    for (size_t part = 0; part < memory_.size(); ++part) {
      if (!IsAsleep(part)) continue;
      const std::string& name = table_.parts()[part].name;
      if (contact.first == name || contact.second == name) return true;
    }
    return false;
  });
  for (const Memory& memory : memory_) {
    std::ranges::copy(memory.contacts, std::back_inserter(contacts));
  }
  SortByNames(&contacts);
  return contacts;
}

void SleepingBodies::Restore(const std::vector<Memory>& memory) {
  Reset();
  if (!is_enabled_) return;
  memory_ = memory;
  for (size_t part = 0; part < memory_.size(); ++part) {
    if (IsAsleep(part)) SetCollides(part, false);
  }
}

}  // namespace cell::vtb
