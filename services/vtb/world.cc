#include "services/vtb/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Distance of the two points by which a thread holds the axis [m].
constexpr double kThreadBase = 0.02;
/// How far each fingertip sinks into what it holds [m]; a touch that is seen.
constexpr double kFingerGive = 0.0005;

Isometry3d ToPose(const mjtNum* position, const mjtNum* quat_wxyz) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(position[0], position[1], position[2]);
  X.linear() =
      Quaterniond(quat_wxyz[0], quat_wxyz[1], quat_wxyz[2], quat_wxyz[3])
          .normalized()
          .toRotationMatrix();
  return X;
}

void Write(const Isometry3d& X, mjtNum* position, mjtNum* quat_wxyz) {
  const Quaterniond q(X.linear());
  for (int i = 0; i < 3; ++i) position[i] = X.translation()[i];
  quat_wxyz[0] = q.w();
  quat_wxyz[1] = q.x();
  quat_wxyz[2] = q.y();
  quat_wxyz[3] = q.z();
}

Isometry3d Between(const Isometry3d& a, const Isometry3d& b, double fraction) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() =
      (1 - fraction) * a.translation() + fraction * b.translation();
  X.linear() = Quaterniond(a.linear())
                   .slerp(fraction, Quaterniond(b.linear()))
                   .toRotationMatrix();
  return X;
}

Isometry3d AlongZ(double z) {
  Isometry3d X = Isometry3d::Identity();
  X.translation().z() = z;
  return X;
}

Isometry3d AboutZ(double angle) {
  return Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
}

mjModel* Compile(const std::string& xml) {
  mjVFS vfs;
  mj_defaultVFS(&vfs);
  const char* file = "world.xml";
  mj_makeEmptyFileVFS(&vfs, file, static_cast<int>(xml.size()));
  std::copy(xml.begin(), xml.end(),
            static_cast<char*>(vfs.filedata[mj_findFileVFS(&vfs, file)]));
  char error[1000] = "";
  mjModel* model = mj_loadXML(file, &vfs, error, sizeof(error));
  mj_deleteVFS(&vfs);
  if (model == nullptr) {
    throw std::invalid_argument(std::string("the world does not compile: ") +
                                error);
  }
  return model;
}

/// What a snapshot keeps of the physics: positions, velocities and the warm
/// start of the solver (without it a run drifts from its copy).
template <class Visitor>
void VisitState(const mjModel& m, mjData& d, mjModel& mutable_model,
                Visitor visit) {
  const auto visit_all = [&](mjtNum* data, int count) {
    visit(std::span<mjtNum>(data, static_cast<size_t>(count)));
  };
  visit_all(&d.time, 1);
  visit_all(d.qpos, m.nq);
  visit_all(d.qvel, m.nv);
  visit_all(d.qacc_warmstart, m.nv);
  visit_all(d.mocap_pos, 3 * m.nmocap);
  visit_all(d.mocap_quat, 4 * m.nmocap);
  visit_all(d.xfrc_applied, 6 * m.nbody);
  visit_all(mutable_model.eq_data, mjNEQDATA * m.neq);
}

}  // namespace

World::World(const PartTable& table, const CellLayout& layout,
             const PhysicsParams& params)
    : table_(std::make_unique<PartTable>(table)),
      layout_(std::make_unique<CellLayout>(layout)),
      params_(params),
      model_(Compile(WorldXml(table, layout, params))),
      data_(mj_makeData(model_.get())) {
  const auto id = [&](mjtObj type, const std::string& name) {
    return mj_name2id(model_.get(), type, name.c_str());
  };
  for (const Part& part : table_->parts()) {
    const int body = id(mjOBJ_BODY, part.name);
    bodies_.push_back(body);
    const int joint = model_->body_jntadr[body];
    qpos_.push_back(joint < 0 ? -1 : model_->jnt_qposadr[joint]);
    centres_.push_back(MomentsOf(part.pieces).centre);
  }
  for (const CellLayout::Hand& hand : layout_->hands) {
    hand_mocaps_.push_back(
        model_->body_mocapid[id(mjOBJ_BODY, hand.name + kWrist)]);
    std::vector<int>& grips = grips_.emplace_back();
    for (const Part& part : table_->parts()) {
      grips.push_back(id(mjOBJ_EQUALITY, GripName(hand.name, part.name)));
    }
  }
  for (const Part& host : table_->parts()) {
    for (const Site& site : host.sites) {
      for (const Part& part : table_->parts()) {
        const int freeze =
            id(mjOBJ_EQUALITY, ThreadFreezeName(site.name, part.name));
        if (freeze < 0) continue;
        threads_.push_back(
            {table_->FindSite(site.name),
             PartIndex(host.name),
             PartIndex(part.name),
             {id(mjOBJ_EQUALITY, ThreadPointName(site.name, part.name, 0)),
              id(mjOBJ_EQUALITY, ThreadPointName(site.name, part.name, 1))},
             freeze,
             ThreadEngagement(*table_->FindThread(site.type))});
      }
    }
  }
  Reset();
}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

void World::Reset() {
  mj_resetData(model_.get(), data_.get());
  std::fill_n(model_->eq_active, model_->neq, mjtByte{0});
  hands_.clear();
  for (size_t i = 0; i < layout_->hands.size(); ++i) {
    Isometry3d X_WG = Isometry3d::Identity();
    X_WG.translation() = layout_->hands[i].p_WG_rest;
    hands_.push_back({X_WG, X_WG, 0, 0, 0, 0, -1, Isometry3d::Identity()});
    PutHand(i, X_WG, 0);
  }
  for (ThreadJoint& joint : threads_) joint.engagement.Restore({});
}

int World::PartIndex(const std::string& part) const {
  for (size_t i = 0; i < table_->parts().size(); ++i) {
    if (table_->parts()[i].name == part) return static_cast<int>(i);
  }
  throw std::invalid_argument("no part is named '" + part + "'");
}

size_t World::HandIndex(const std::string& hand) const {
  for (size_t i = 0; i < layout_->hands.size(); ++i) {
    if (layout_->hands[i].name == hand) return i;
  }
  throw std::invalid_argument("no hand is named '" + hand + "'");
}

bool World::IsHeld(int part) const {
  return std::ranges::any_of(
      hands_, [&](const HandState& hand) { return hand.part == part; });
}

void World::Place(const std::string& part, const Isometry3d& X_WO) {
  const int address = qpos_[static_cast<size_t>(PartIndex(part))];
  if (address < 0) throw std::invalid_argument(part + " is fixed");
  Write(X_WO, data_->qpos + address, data_->qpos + address + 3);
}

void World::MoveHand(const std::string& hand, const Isometry3d& X_WG,
                     double opening) {
  HandState& state = hands_[HandIndex(hand)];
  state.X_WG_goal = X_WG;
  state.opening_goal = opening;
}

void World::Grip(const std::string& hand, const std::string& part) {
  const size_t index = HandIndex(hand);
  HandState& state = hands_[index];
  if (state.part >= 0) throw std::logic_error(hand + " holds a part already");
  const int part_index = PartIndex(part);
  const int grip = grips_[index][static_cast<size_t>(part_index)];
  if (grip < 0) throw std::invalid_argument(part + " is fixed");
  state.part = part_index;
  state.roll = state.roll_goal = 0;
  state.X_GO_grip = state.X_WG.inverse() * PoseAt(part_index);
  const int body = bodies_[static_cast<size_t>(part_index)];
  // The person carries the weight.
  data_->xfrc_applied[6 * body + 2] =
      -model_->opt.gravity[2] * model_->body_mass[body];
  model_->eq_active[grip] = 1;
  PullGrip(index, state.X_WG, 0);
}

void World::Release(const std::string& hand) {
  const size_t index = HandIndex(hand);
  HandState& state = hands_[index];
  if (state.part < 0) throw std::logic_error(hand + " holds nothing");
  const auto part = static_cast<size_t>(state.part);
  model_->eq_active[grips_[index][part]] = 0;
  data_->xfrc_applied[6 * bodies_[part] + 2] = 0;
  state.part = -1;
  state.roll = state.roll_goal = 0;
}

void World::Roll(const std::string& hand, double angle) {
  hands_[HandIndex(hand)].roll_goal = angle;
}

std::optional<std::string> World::HeldBy(const std::string& hand) const {
  const int part = hands_[HandIndex(hand)].part;
  if (part < 0) return std::nullopt;
  return table_->parts()[static_cast<size_t>(part)].name;
}

void World::Run(int num_steps) {
  const double duration = num_steps * params_.dt;
  for (int step = 1; step <= num_steps; ++step) {
    const double fraction = static_cast<double>(step) / num_steps;
    for (size_t i = 0; i < hands_.size(); ++i) {
      StepHand(i, fraction, duration);
    }
    for (ThreadJoint& joint : threads_) StepThread(joint);
    mj_step(model_.get(), data_.get());
  }
  CheckPhysics();
  for (HandState& hand : hands_) {
    hand.X_WG = hand.X_WG_goal;
    hand.opening = hand.opening_goal;
    hand.roll = hand.roll_goal;
  }
}

/// MuJoCo goes on after an overflow or an explosion; results would be nonsense.
void World::CheckPhysics() const {
  for (int i = 0; i < mjNWARNING; ++i) {
    const mjWarningStat& warning = data_->warning[i];
    if (warning.number == 0) continue;
    throw std::runtime_error(
        fmt::format("physics broke down at {:.3f} s: {}", data_->time,
                    mju_warningText(i, static_cast<size_t>(warning.lastinfo))));
  }
}

void World::StepHand(size_t index, double fraction, double duration) {
  const HandState& hand = hands_[index];
  const Isometry3d X_WG = Between(hand.X_WG, hand.X_WG_goal, fraction);
  PutHand(index, X_WG,
          hand.opening + fraction * (hand.opening_goal - hand.opening));
  if (hand.part < 0) return;
  // The spring drags on what moves: the wrist pulls from ahead, so that the
  // part stays where the fingers are.
  const double lead = 2 * 0.95 * params_.grip_time_constant / duration;
  Isometry3d X_WL = X_WG;
  X_WL.translation() +=
      lead * (hand.X_WG_goal.translation() - hand.X_WG.translation());
  const Eigen::AngleAxisd turn(Quaterniond(hand.X_WG_goal.linear()) *
                               Quaterniond(hand.X_WG.linear()).conjugate());
  X_WL.linear() =
      Eigen::AngleAxisd(lead * turn.angle(), turn.axis()).toRotationMatrix() *
      X_WL.linear();
  PullGrip(index, X_WL,
           hand.roll + (fraction + lead) * (hand.roll_goal - hand.roll));
}

void World::PutHand(size_t index, const Isometry3d& X_WG, double opening) {
  const auto put = [&](int offset, const CellLayout::HandBox& box, double x) {
    const Isometry3d X_GB(Eigen::Translation3d(x, 0, box.z));
    SetMocap(hand_mocaps_[index] + offset, X_WG * X_GB);
  };
  // Bodies follow each other in the model: wrist, palm, thumb, fingers.
  SetMocap(hand_mocaps_[index], X_WG);
  const double half = opening / 2 - kFingerGive;
  put(1, layout_->palm, 0);
  put(2, layout_->thumb, -half - layout_->thumb.half_extents.x());
  put(3, layout_->fingers, half + layout_->fingers.half_extents.x());
}

void World::PullGrip(size_t index, const Isometry3d& X_WL, double roll) {
  const HandState& hand = hands_[index];
  SetMocap(hand_mocaps_[index], X_WL);
  const auto part = static_cast<size_t>(hand.part);
  SetWeld(grips_[index][part], hand.part, AboutZ(roll) * hand.X_GO_grip);
}

void World::StepThread(ThreadJoint& joint) {
  const Isometry3d X_WH = PoseAt(joint.host);
  const Isometry3d& X_HS = joint.site->X_HS;
  const Isometry3d X_SO = X_HS.inverse() * X_WH.inverse() * PoseAt(joint.part);
  joint.engagement.Update(X_SO, IsHeld(joint.part));
  const ThreadEngagement::State state = joint.engagement.memory().state;
  const bool is_engaged = state == ThreadEngagement::State::kEngaged;
  for (const int i : {0, 1}) {
    const int equality = joint.points[i];
    model_->eq_active[equality] = is_engaged;
    if (!is_engaged) continue;
    mjtNum* anchors = model_->eq_data + mjNEQDATA * equality;
    const Vector3d p_S(0, 0, i * kThreadBase);
    Eigen::Map<Vector3d>(anchors, 3) = X_HS * p_S;
    Eigen::Map<Vector3d>(anchors + 3, 3) =
        AlongZ(-joint.engagement.memory().remaining) * p_S;
  }
  const bool is_frozen = state == ThreadEngagement::State::kFrozen;
  model_->eq_active[joint.freeze] = is_frozen;
  if (is_frozen) {
    SetWeld(joint.freeze, joint.part, X_HS * joint.engagement.X_SO());
  }
}

void World::SetMocap(int mocap, const Isometry3d& X) {
  Write(X, data_->mocap_pos + 3 * mocap, data_->mocap_quat + 4 * mocap);
}

/// X_1O: pose that the part shall have in the weld's first body. The weld acts
/// at the part's centre of mass, so that its turning does not shift it.
void World::SetWeld(int equality, int part, const Isometry3d& X_1O) {
  mjtNum* data = model_->eq_data + mjNEQDATA * equality;
  const Vector3d& centre = centres_[static_cast<size_t>(part)];
  Isometry3d X_1C = X_1O;
  X_1C.translation() = X_1O * centre;
  Eigen::Map<Vector3d>(data, 3) = centre;
  Write(X_1C, data + 3, data + 6);
  data[10] = 1;
}

double World::time() const {
  return data_->time;
}
int World::num_contacts() const {
  return data_->ncon;
}

Isometry3d World::PoseAt(int part) const {
  const auto index = static_cast<size_t>(part);
  const int address = qpos_[index];
  if (address < 0) return layout_->pedestal.X_WP;
  return ToPose(data_->qpos + address, data_->qpos + address + 3);
}

Isometry3d World::PoseOf(const std::string& part) const {
  return PoseAt(PartIndex(part));
}

double World::SpeedOf(const std::string& part) const {
  const int body = bodies_[static_cast<size_t>(PartIndex(part))];
  const int dof = model_->body_dofadr[body];
  if (dof < 0) return 0;
  return Eigen::Map<const Vector3d>(data_->qvel + dof).norm();
}

const World::ThreadJoint* World::FindJoint(const std::string& site,
                                           const std::string& part) const {
  const int index = PartIndex(part);
  for (const ThreadJoint& joint : threads_) {
    if (joint.site->name == site && joint.part == index) return &joint;
  }
  return nullptr;
}

bool World::IsOnThread(const std::string& site, const std::string& part) const {
  const ThreadJoint* joint = FindJoint(site, part);
  return joint != nullptr &&
         joint->engagement.memory().state != ThreadEngagement::State::kOpen;
}

bool World::IsTurnedHome(const std::string& site,
                         const std::string& part) const {
  const ThreadJoint* joint = FindJoint(site, part);
  return joint != nullptr &&
         joint->engagement.memory().state == ThreadEngagement::State::kFrozen &&
         joint->engagement.memory().remaining <= 0;
}

std::vector<BodyPose> World::Bodies() const {
  std::vector<BodyPose> bodies;
  for (size_t i = 0; i < table_->parts().size(); ++i) {
    bodies.push_back({table_->parts()[i].name, PoseAt(static_cast<int>(i))});
  }
  for (size_t i = 0; i < hands_.size(); ++i) {
    int mocap = hand_mocaps_[i];
    for (const char* box : {kPalm, kThumb, kFingers}) {
      ++mocap;
      bodies.push_back({layout_->hands[i].name + box,
                        ToPose(data_->mocap_pos + 3 * mocap,
                               data_->mocap_quat + 4 * mocap)});
    }
  }
  return bodies;
}

std::vector<BodyContact> World::Contacts() const {
  std::map<std::pair<std::string, std::string>, BodyContact> pairs;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const auto name = [&](int geom) -> std::string {
      const int body = model_->geom_bodyid[geom];
      return body == 0 ? kTableName
                       : mj_id2name(model_.get(), mjOBJ_BODY, body);
    };
    std::string first = name(contact.geom1), second = name(contact.geom2);
    if (second < first) std::swap(first, second);
    const auto [it, is_new] = pairs.try_emplace({first, second});
    BodyContact& pair = it->second;
    mjtNum force[6];
    mj_contactForce(model_.get(), data_.get(), i, force);
    pair.normal_force += force[0];
    if (is_new || contact.dist < pair.distance) {
      pair.first = first;
      pair.second = second;
      pair.distance = contact.dist;
      pair.p_W = Vector3d(contact.pos[0], contact.pos[1], contact.pos[2]);
    }
  }
  std::vector<BodyContact> contacts;
  for (auto& [names, contact] : pairs) contacts.push_back(std::move(contact));
  return contacts;
}

World::Snapshot World::Save() const {
  Snapshot snapshot;
  VisitState(*model_, *data_, *model_, [&](std::span<mjtNum> numbers) {
    snapshot.numbers.insert(snapshot.numbers.end(), numbers.begin(),
                            numbers.end());
  });
  snapshot.active.assign(model_->eq_active, model_->eq_active + model_->neq);
  snapshot.hands = hands_;
  for (const ThreadJoint& joint : threads_) {
    snapshot.threads.push_back(joint.engagement.memory());
  }
  return snapshot;
}

void World::Restore(const Snapshot& snapshot) {
  auto next = snapshot.numbers.begin();
  VisitState(*model_, *data_, *model_, [&](std::span<mjtNum> numbers) {
    std::copy_n(next, numbers.size(), numbers.begin());
    next += static_cast<std::ptrdiff_t>(numbers.size());
  });
  std::ranges::copy(snapshot.active, model_->eq_active);
  hands_ = snapshot.hands;
  for (size_t i = 0; i < threads_.size(); ++i) {
    threads_[i].engagement.Restore(snapshot.threads.at(i));
  }
}

}  // namespace cell
