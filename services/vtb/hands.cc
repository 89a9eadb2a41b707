#include "services/vtb/hands.h"

#include <algorithm>
#include <stdexcept>

#include "services/vtb/mujoco_pose.h"
#include "services/vtb/world_xml.h"

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How far each fingertip sinks into what it holds [m]; a touch that is seen.
constexpr double kFingerGive = 0.0005;
constexpr double kRestOpening = 0.0;
constexpr double kAboveBase = 0.7;  // [m]

Isometry3d Between(const Isometry3d& a, const Isometry3d& b, double fraction) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() =
      (1 - fraction) * a.translation() + fraction * b.translation();
  X.linear() = Quaterniond(a.linear())
                   .slerp(fraction, Quaterniond(b.linear()))
                   .toRotationMatrix();
  return X;
}

Isometry3d AboutZ(double angle) {
  return Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
}

/// 1, or -1 if the weld's error of rotation is near the quaternion -1.
double WeldSide(const mjModel& model, const mjData& data, int equality) {
  const auto quat = [](const mjtNum* wxyz) {
    return Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  };
  const Quaterniond q_W1 = quat(data.xquat + 4 * model.eq_obj1id[equality]);
  const Quaterniond q_W2 = quat(data.xquat + 4 * model.eq_obj2id[equality]);
  const Quaterniond q_12 = quat(model.eq_data + mjNEQDATA * equality + 6);
  return (q_W2.conjugate() * q_W1 * q_12).w() < 0 ? -1 : 1;
}

}  // namespace

Hands::Hands(const PartTable& table, const CellLayout& layout,
             const PartBodies& bodies, mjModel& model, mjData& data)
    : table_(table), model_(model), data_(data), bodies_(bodies) {
  const auto id = [&](mjtObj type, const std::string& name) {
    return mj_name2id(&model_, type, name.c_str());
  };
  const auto add = [&](const std::string& name, const HandType& type) {
    Fixture& fixture = fixtures_.emplace_back();
    fixture.name = name;
    fixture.type = &type;
    fixture.mocap = model_.body_mocapid[id(mjOBJ_BODY, name + kWrist)];
    for (const Part& part : table.parts()) {
      fixture.grips.push_back(id(mjOBJ_EQUALITY, GripName(name, part.name)));
    }
  };
  for (const CellLayout::Hand& hand : layout.hands) {
    add(hand.name, hand.type);
    fixtures_.back().is_person = true;
    fixtures_.back().X_WG_rest.translation() = hand.p_WG_rest;
  }
  for (const ArmLayout& arm : layout.arms) {
    add(arm.gripper, arm.hand);
    // Over its base, until an arm carries it.
    fixtures_.back().X_WG_rest =
        arm.X_WB * Eigen::Translation3d(0, 0, kAboveBase);
  }
  Reset();
}

void Hands::Reset() {
  states_.assign(fixtures_.size(), {});
  for (size_t i = 0; i < fixtures_.size(); ++i) {
    State& state = states_[i];
    state.X_WG = state.X_WG_goal = fixtures_[i].X_WG_rest;
    state.opening = state.opening_goal = kRestOpening;
    fixtures_[i].sum = {};
    fixtures_[i].num_steps = 0;
    Put(i, state.X_WG, state.opening);
  }
}

size_t Hands::IndexOf(const std::string& hand) const {
  for (size_t i = 0; i < fixtures_.size(); ++i) {
    if (fixtures_[i].name == hand) return i;
  }
  throw std::invalid_argument("no hand is named '" + hand + "'");
}

void Hands::Move(const std::string& hand, const Isometry3d& X_WG,
                 double opening) {
  State& state = states_[IndexOf(hand)];
  state.X_WG_goal = X_WG;
  state.opening_goal = opening;
}

void Hands::Place(const std::string& hand, const Isometry3d& X_WG,
                  double opening) {
  const size_t index = IndexOf(hand);
  State& state = states_[index];
  state.X_WG = state.X_WG_goal = X_WG;
  state.opening = state.opening_goal = opening;
  Put(index, X_WG, opening);
}

void Hands::PlaceFingers(const std::string& hand, const std::string& grip) {
  const size_t index = IndexOf(hand);
  const HandType& type = *fixtures_[index].type;
  const HandType::Grip* found = type.FindGrip(grip);
  if (found == nullptr) {
    throw std::invalid_argument(hand + " has no grip '" + grip + "'");
  }
  states_[index].grip = static_cast<size_t>(found - type.grips.data());
}

void Hands::Grip(const std::string& hand, const std::string& part) {
  const size_t index = IndexOf(hand);
  const Fixture& fixture = fixtures_[index];
  State& state = states_[index];
  if (state.part >= 0) throw std::logic_error(hand + " already holds a part");
  const size_t p = bodies_.IndexOf(part);
  if (fixture.grips[p] < 0) throw std::invalid_argument(part + " is fixed");
  state.part = static_cast<int>(p);
  state.roll = state.roll_goal = 0;
  state.X_GO_grip = state.X_WG.inverse() * bodies_.PoseOf(p, data_);
  if (fixture.is_person && table_.parts()[p].is_free()) {
    // The person carries the weight.
    const int body = bodies_[p].id;
    data_.xfrc_applied[6 * body + 2] =
        -model_.opt.gravity[2] * model_.body_mass[body];
  }
  model_.eq_active[fixture.grips[p]] = 1;
  Pull(index, state.X_WG, 0);
}

void Hands::Release(const std::string& hand) {
  const size_t index = IndexOf(hand);
  State& state = states_[index];
  if (state.part < 0) throw std::logic_error(hand + " holds nothing");
  const auto part = static_cast<size_t>(state.part);
  model_.eq_active[fixtures_[index].grips[part]] = 0;
  data_.xfrc_applied[6 * bodies_[part].id + 2] = 0;
  state.part = -1;
  state.roll = state.roll_goal = 0;
}

void Hands::Roll(const std::string& hand, double angle) {
  states_[IndexOf(hand)].roll_goal = angle;
}

std::optional<std::string> Hands::HeldBy(const std::string& hand) const {
  const int part = StateOf(hand).part;
  if (part < 0) return std::nullopt;
  return table_.parts()[static_cast<size_t>(part)].name;
}

const Hands::State& Hands::StateOf(const std::string& hand) const {
  return states_[IndexOf(hand)];
}

bool Hands::IsHeld(const std::string& part) const {
  return IsHeld(static_cast<int>(bodies_.IndexOf(part)));
}

bool Hands::IsHeld(int part) const {
  return std::ranges::find(states_, part, &State::part) != states_.end();
}

void Hands::BeforeRun() {
  for (Fixture& fixture : fixtures_) {
    fixture.sum = {};
    fixture.num_steps = 0;
  }
}

void Hands::BeforeStep(double fraction, double duration) {
  for (size_t i = 0; i < states_.size(); ++i) Step(i, fraction, duration);
}

void Hands::AfterStep() {
  for (size_t i = 0; i < states_.size(); ++i) {
    ++fixtures_[i].num_steps;
    if (states_[i].part < 0 || fixtures_[i].is_person) continue;
    const Wrench wrench = GripWrench(i);
    fixtures_[i].sum.force += wrench.force;
    fixtures_[i].sum.torque += wrench.torque;
  }
}

void Hands::AfterRun() {
  for (State& state : states_) {
    state.X_WG = state.X_WG_goal;
    state.opening = state.opening_goal;
    state.roll = state.roll_goal;
  }
}

void Hands::Step(size_t index, double fraction, double duration) {
  const State& state = states_[index];
  const Isometry3d X_WG = Between(state.X_WG, state.X_WG_goal, fraction);
  Put(index, X_WG,
      state.opening + fraction * (state.opening_goal - state.opening));
  if (state.part < 0) return;
  // The spring drags on what moves: the wrist pulls from ahead, so that the
  // part stays where the fingers are.
  const int grip = fixtures_[index].grips[static_cast<size_t>(state.part)];
  const double lead = 2 * model_.eq_solimp[mjNIMP * grip] *
                      model_.eq_solref[mjNREF * grip] / duration;
  Isometry3d X_WL = X_WG;
  X_WL.translation() +=
      lead * (state.X_WG_goal.translation() - state.X_WG.translation());
  const Eigen::AngleAxisd turn(Quaterniond(state.X_WG_goal.linear()) *
                               Quaterniond(state.X_WG.linear()).conjugate());
  X_WL.linear() =
      Eigen::AngleAxisd(lead * turn.angle(), turn.axis()).toRotationMatrix() *
      X_WL.linear();
  Pull(index, X_WL,
       state.roll + (fraction + lead) * (state.roll_goal - state.roll));
}

Isometry3d Hands::PlaceOf(const HandType::Grip& grip, size_t box,
                          double opening) {
  return HandType::PlaceOf(grip, box, opening - 2 * kFingerGive);
}

void Hands::Put(size_t index, const Isometry3d& X_WG, double opening) {
  const Fixture& fixture = fixtures_[index];
  const auto set = [&](int mocap, const Isometry3d& X_WB) {
    PoseToMujoco(X_WB, data_.mocap_pos + 3 * mocap,
                 data_.mocap_quat + 4 * mocap);
  };
  set(fixture.mocap, X_WG);
  const HandType::Grip& grip = fixture.type->grips[states_[index].grip];
  for (size_t i = 0; i < grip.places.size(); ++i) {
    set(fixture.mocap + 1 + static_cast<int>(i),
        X_WG * PlaceOf(grip, i, opening));
  }
}

void Hands::Pull(size_t index, const Isometry3d& X_WL, double roll) {
  const State& state = states_[index];
  const int mocap = fixtures_[index].mocap;
  PoseToMujoco(X_WL, data_.mocap_pos + 3 * mocap, data_.mocap_quat + 4 * mocap);
  const auto part = static_cast<size_t>(state.part);
  SetWeld(AboutZ(roll) * state.X_GO_grip, bodies_[part].centre, model_,
          fixtures_[index].grips[part]);
}

Wrench Hands::GripWrench(size_t index) const {
  const State& state = states_[index];
  const auto part = static_cast<size_t>(state.part);
  const int equality = fixtures_[index].grips[part];
  return table_.parts()[part].joint ? OnArticulatedPart(state, equality)
                                    : OnFreePart(state, equality);
}

/// The weld's rows of the constraints, as the part's free joint feels them:
/// three forces in W at its origin, three torques in O.
Wrench Hands::OnFreePart(const State& state, int equality) const {
  const auto part = static_cast<size_t>(state.part);
  const int dof = bodies_[part].dof;
  Eigen::Matrix<double, 6, 1> on_part = Eigen::Matrix<double, 6, 1>::Zero();
  for (int row = 0; row < data_.nefc; ++row) {
    if (data_.efc_type[row] != mjCNSTR_EQUALITY ||
        data_.efc_id[row] != equality) {
      continue;
    }
    const int address = data_.efc_J_rowadr[row];
    for (int k = 0; k < data_.efc_J_rownnz[row]; ++k) {
      const int column = data_.efc_J_colind[address + k] - dof;
      if (column < 0 || column >= 6) continue;
      on_part[column] += data_.efc_J[address + k] * data_.efc_force[row];
    }
  }
  const Isometry3d X_WO = bodies_.PoseOf(part, data_);
  const Isometry3d X_GO = AboutZ(state.roll) * state.X_GO_grip;
  const Eigen::Matrix3d R_GW = X_GO.linear() * X_WO.linear().transpose();
  Wrench on_hand;
  on_hand.force = -R_GW * on_part.head<3>();
  on_hand.torque = -X_GO.linear() * on_part.tail<3>() +
                   X_GO.translation().cross(on_hand.force);
  return on_hand;
}

/// A joint feels one component only, so here the rows themselves: the weld
/// pushes the wrist by their force f [N] in W at the part's centre of mass, and
/// turns it by half of the rest [N m] in O (its error of rotation is the vector
/// part of a quaternion, of either sign).
Wrench Hands::OnArticulatedPart(const State& state, int equality) const {
  const auto part = static_cast<size_t>(state.part);
  Eigen::Matrix<double, 6, 1> rows = Eigen::Matrix<double, 6, 1>::Zero();
  int num_rows = 0;
  for (int row = 0; row < data_.nefc && num_rows < 6; ++row) {
    if (data_.efc_type[row] == mjCNSTR_EQUALITY &&
        data_.efc_id[row] == equality) {
      rows[num_rows++] = data_.efc_force[row];
    }
  }
  const Isometry3d X_WO = bodies_.PoseOf(part, data_);
  const Isometry3d X_GO = AboutZ(state.roll) * state.X_GO_grip;
  Wrench on_hand;
  on_hand.force = X_GO.linear() * X_WO.linear().transpose() * rows.head<3>();
  on_hand.torque =
      WeldSide(model_, data_, equality) * X_GO.linear() * rows.tail<3>() / 2 +
      (X_GO * bodies_[part].centre).cross(on_hand.force);
  return on_hand;
}

Wrench Hands::WrenchOn(const std::string& hand) const {
  const Fixture& fixture = fixtures_[IndexOf(hand)];
  if (fixture.num_steps == 0) return {};
  return {fixture.sum.force / fixture.num_steps,
          fixture.sum.torque / fixture.num_steps};
}

std::vector<BodyPose> Hands::Bodies() const {
  std::vector<BodyPose> bodies;
  for (const Fixture& fixture : fixtures_) {
    int mocap = fixture.mocap;
    for (const HandType::Box& box : fixture.type->boxes) {
      ++mocap;
      bodies.push_back({fixture.name + "." + box.name,
                        PoseFromMujoco(data_.mocap_pos + 3 * mocap,
                                       data_.mocap_quat + 4 * mocap)});
    }
  }
  return bodies;
}

}  // namespace cell::vtb
