#include "services/vtb/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "services/vtb/mujoco_pose.h"

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Distance of the two points by which a thread holds the axis [m].
constexpr double kThreadBase = 0.02;

Isometry3d AlongZ(double z) {
  return Isometry3d(Eigen::Translation3d(0, 0, z));
}

/// MuJoCo itself would write a file where the cell runs, and wait for a key.
bool ReportWithoutFiles() {
  // CheckPhysics() reports the warnings, which mjData counts.
  mju_user_warning = [](const char*) {
  };
  mju_user_error = [](const char* message) {
    throw std::runtime_error(std::string("physics: ") + message);
  };
  return true;
}

mjModel* Compile(const std::string& xml) {
  [[maybe_unused]] static const bool is_told = ReportWithoutFiles();
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
  bodies_ = std::make_unique<PartBodies>(*table_, *layout_, *model_);
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
  hands_ =
      std::make_unique<Hands>(*table_, *layout_, *bodies_, *model_, *data_);
  sleeping_ = std::make_unique<SleepingBodies>(
      *table_, *layout_, *bodies_, *hands_, *model_, *data_, params_.sleep);
  Reset();
}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

void World::Reset() {
  mj_resetData(model_.get(), data_.get());
  std::fill_n(model_->eq_active, model_->neq, mjtByte{0});
  hands_->Reset();
  sleeping_->Reset();
  for (ThreadJoint& joint : threads_) joint.engagement.Restore({});
}

int World::PartIndex(const std::string& part) const {
  return static_cast<int>(bodies_->IndexOf(part));
}

void World::Place(const std::string& part, const Isometry3d& X_WO) {
  const size_t index = bodies_->IndexOf(part);
  if (!table_->parts()[index].is_free()) {
    throw std::invalid_argument(part + " is fixed or moves on a joint");
  }
  sleeping_->Wake(index);
  const int address = (*bodies_)[index].qpos;
  PoseToMujoco(X_WO, data_->qpos + address, data_->qpos + address + 3);
}

size_t World::ArticulatedIndex(const std::string& part) const {
  const size_t index = bodies_->IndexOf(part);
  if (!table_->parts()[index].joint) {
    throw std::invalid_argument(part + " is not articulated");
  }
  return index;
}

void World::SetJoint(const std::string& part, double position) {
  const size_t index = ArticulatedIndex(part);
  sleeping_->Wake(index);
  const PartBodies::Body& body = (*bodies_)[index];
  data_->qpos[body.qpos] = position;
  data_->qvel[body.dof] = 0;
}

double World::JointOf(const std::string& part) const {
  return data_->qpos[(*bodies_)[ArticulatedIndex(part)].qpos];
}

void World::Run(int num_steps) {
  const double duration = num_steps * params_.dt;
  hands_->BeforeRun();
  sleeping_->BeforeRun(duration);
  for (int step = 1; step <= num_steps; ++step) {
    const double fraction = static_cast<double>(step) / num_steps;
    hands_->BeforeStep(fraction, duration);
    sleeping_->BeforeStep();
    Step();
    hands_->AfterStep();
  }
  CheckPhysics();
  hands_->AfterRun();
}

void World::Step() {
  if (sleeping_->AreAllAsleep()) {
    data_->time += model_->opt.timestep;
    return;
  }
  for (ThreadJoint& joint : threads_) StepThread(joint);
  mj_step(model_.get(), data_.get());
  sleeping_->AfterStep();
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

void World::StepThread(ThreadJoint& joint) {
  const Isometry3d X_WH = PoseAt(joint.host);
  const Isometry3d& X_HS = joint.site->X_HS;
  const Isometry3d X_SO = X_HS.inverse() * X_WH.inverse() * PoseAt(joint.part);
  joint.engagement.Update(X_SO, hands_->IsHeld(joint.part));
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
  const bool is_frozen = state == ThreadEngagement::State::kFrozen &&
                         !sleeping_->IsAsleep(static_cast<size_t>(joint.part));
  model_->eq_active[joint.freeze] = is_frozen;
  if (is_frozen) {
    SetWeld(X_HS * joint.engagement.X_SO(),
            (*bodies_)[static_cast<size_t>(joint.part)].centre, *model_,
            joint.freeze);
  }
}

double World::time() const {
  return data_->time;
}

Isometry3d World::PoseAt(int part) const {
  return bodies_->PoseOf(static_cast<size_t>(part), *data_);
}

Isometry3d World::PoseOf(const std::string& part) const {
  return PoseAt(PartIndex(part));
}

double World::SpeedOf(const std::string& part) const {
  return bodies_->SpeedOf(bodies_->IndexOf(part), *data_);
}

bool World::IsAsleep(const std::string& part) const {
  return sleeping_->IsAsleep(bodies_->IndexOf(part));
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
  for (BodyPose& body : hands_->Bodies()) bodies.push_back(std::move(body));
  return bodies;
}

std::vector<BodyContact> World::Contacts() const {
  return sleeping_->Contacts();
}

World::Snapshot World::Save() const {
  Snapshot snapshot;
  VisitState(*model_, *data_, *model_, [&](std::span<mjtNum> numbers) {
    snapshot.numbers.insert(snapshot.numbers.end(), numbers.begin(),
                            numbers.end());
  });
  snapshot.active.assign(model_->eq_active, model_->eq_active + model_->neq);
  snapshot.hands = hands_->states();
  for (const ThreadJoint& joint : threads_) {
    snapshot.threads.push_back(joint.engagement.memory());
  }
  snapshot.sleeping = sleeping_->memory();
  return snapshot;
}

void World::Restore(const Snapshot& snapshot) {
  auto next = snapshot.numbers.begin();
  VisitState(*model_, *data_, *model_, [&](std::span<mjtNum> numbers) {
    std::copy_n(next, numbers.size(), numbers.begin());
    next += static_cast<std::ptrdiff_t>(numbers.size());
  });
  std::ranges::fill(data_->warning, mjWarningStat{});
  std::ranges::copy(snapshot.active, model_->eq_active);
  hands_->Restore(snapshot.hands);
  for (size_t i = 0; i < threads_.size(); ++i) {
    threads_[i].engagement.Restore(snapshot.threads.at(i));
  }
  sleeping_->Restore(snapshot.sleeping);
}

}  // namespace cell::vtb
