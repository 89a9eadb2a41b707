#include "services/vtb/vtb.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "cell/episode_t.hpp"
#include "cell/truth_action_t.hpp"
#include "cell/truth_contacts_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/geometry/pose.h"

namespace cell {
namespace {

constexpr double kTick = 1e-6 * kTickUs;  // [s]
/// Between the end of an episode and the next beginning, or the run's end: what
/// is under way in the other services comes out.
constexpr int32_t kGapTicks = 125;
constexpr int32_t kFirstTick = 1;
constexpr int32_t kRunningPeriod = 125;
constexpr int32_t kForeverTicks = 1 << 30;
/// An episode ends when everything has been still so long, or anyway after ...
constexpr int32_t kRestTicks = 125, kMaxRestTicks = 625;
constexpr double kStill = 0.002;  // [m/s]

int StepsPerTick(double dt) {
  const double steps = kTick / dt;
  const double rounded = std::round(steps);
  if (!(rounded >= 1) || std::abs(steps - rounded) > 1e-9) {
    throw std::invalid_argument(
        fmt::format("{} s is no whole part of a tick of {} s", dt, kTick));
  }
  return static_cast<int>(rounded);
}

}  // namespace

Vtb::Vtb(Bus& bus, const Params& params)
    : bus_(bus),
      params_(params),
      steps_per_tick_(StepsPerTick(params.physics.dt)),
      world_(params.parts, params.layout, params.physics),
      book_(std::make_shared<DemonstratorBook>(params.book)) {
  Prepare(params.first);
  next_ = {kFirstTick, params.first};
  bus_.Subscribe<command_episode_t>(
      "COMMAND_EPISODE",
      [this](const command_episode_t& m) { return OnCommand(m); });
  bus_.Every(1, 0, [this] { OnTick(); });
}

void Vtb::Prepare(const Request& request) {
  demonstrator_.emplace(book_, request.demonstration, request.seed, world_);
  deeds_.emplace(book_);
  request_ = request;
  num_still_ = 0;
}

bool Vtb::OnCommand(const command_episode_t& message) {
  if (bus_.now() > message.deadline_utime) return false;
  switch (message.action) {
    case command_episode_t::END:
      next_.reset();
      is_running_ ? End() : bus_.EndRunIn(kGapTicks);
      return true;
    case command_episode_t::START: {
      if (!book_->scripts.contains(message.demonstration)) return false;
      if (is_running_) End();
      next_ = {bus_.tick() + kGapTicks,
               {message.demonstration, static_cast<uint64_t>(message.seed)}};
      bus_.EndRunIn(kForeverTicks - bus_.tick());
      return true;
    }
    default:
      return false;
  }
}

void Vtb::OnTick() {
  if (bus_.tick() < kFirstTick) return;
  if (next_ && bus_.tick() >= next_->tick) {
    if (episode_ > 0) Prepare(next_->request);
    next_.reset();
    ++episode_;
    is_running_ = true;
    PublishEpisode(episode_t::START);
  }
  demonstrator_->Update(kTick, world_);
  world_.Run(steps_per_tick_);
  if (bus_.tick() % params_.truth_period_ticks == 0) PublishTruth();
  if (is_running_) PublishDeeds();
  if (is_running_ && bus_.tick() % kRunningPeriod == 0) {
    PublishEpisode(episode_t::RUNNING);
  }
  if (is_running_ && IsAtRest()) End();
}

bool Vtb::IsAtRest() {
  if (!demonstrator_->is_done()) {
    num_still_ = 0;
    return false;
  }
  ++num_still_;
  if (num_still_ < kRestTicks) return false;
  if (num_still_ >= kMaxRestTicks) return true;
  for (const Part& part : world_.table().parts()) {
    if (world_.SpeedOf(part.name) > kStill) return false;
  }
  return true;
}

void Vtb::End() {
  is_running_ = false;
  PublishEpisode(episode_t::END);
  bus_.EndRunIn(kGapTicks);
}

void Vtb::PublishEpisode(int8_t phase) {
  episode_t message{};
  message.header.utime = bus_.now();
  message.id = episode_;
  message.phase = phase;
  message.task = params_.task;
  message.goal = book_->goal;
  message.agent = "person";
  message.demonstration = request_.demonstration;
  message.seed = static_cast<int64_t>(request_.seed);
  bus_.Publish("EPISODE", message);
}

void Vtb::PublishTruth() {
  truth_poses_t poses{};
  poses.header.utime = bus_.now();
  for (const BodyPose& body : world_.Bodies()) {
    poses.bodies.push_back({body.name, PoseToMessage(body.X_WB)});
  }
  poses.num_bodies = static_cast<int32_t>(poses.bodies.size());
  bus_.Publish("TRUTH_POSES", poses);

  truth_contacts_t contacts{};
  contacts.header.utime = bus_.now();
  for (const BodyContact& contact : world_.Contacts()) {
    contact_t& c = contacts.contacts.emplace_back();
    c.first = contact.first;
    c.second = contact.second;
    Eigen::Map<Eigen::Vector3d>(c.position) = contact.p_W;
    c.distance = contact.distance;
    c.normal_force = contact.normal_force;
  }
  contacts.num_contacts = static_cast<int32_t>(contacts.contacts.size());
  bus_.Publish("TRUTH_CONTACTS", contacts);
}

void Vtb::PublishDeeds() {
  static_assert(static_cast<int>(Deed::Kind::kTipped) ==
                truth_action_t::TIPPED);
  static_assert(static_cast<int>(Deed::Mistake::kOutOfWorkspace) ==
                truth_action_t::OUT_OF_WORKSPACE);
  for (const Deed& deed : deeds_->Update(bus_.now(), world_)) {
    truth_action_t message{};
    message.header.utime = deed.place_utime;
    message.kind = static_cast<int8_t>(deed.kind);
    message.mistake = static_cast<int8_t>(deed.mistake);
    message.part = deed.part;
    message.site = deed.site;
    message.hand = deed.hand;
    message.pick_utime = deed.pick_utime;
    bus_.Publish("TRUTH_ACTIONS", message);
  }
}

std::unique_ptr<Service> MakeVtb(Bus& bus, const Deployment& deployment,
                                 const std::string& demonstration,
                                 uint64_t seed) {
  Vtb::Params params;
  // The folder may be given with a slash at its end.
  params.task = (deployment.task_dir / "").parent_path().filename().string();
  params.parts = PartTable::FromConfig(deployment.OfTask("parts.yaml"));
  params.layout = CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  params.book = DemonstratorBook::FromConfig(
      deployment.OfTask("demonstrators.yaml"), params.parts);

  const Config config = deployment.ForService("vtb");
  params.physics.dt = 1e-3 * config.Number("step_ms", 0.1, 4);
  params.physics.friction = config.Number("friction", 0, 2);
  params.physics.grip_time_constant =
      1e-3 * config.Number("grip_time_constant_ms", 2, 200);
  params.truth_period_ticks = config.Integer("truth_period_ticks", 1, 1250);
  const auto configured = config.Get<std::string>("demonstration");
  if (!params.book.scripts.contains(configured)) {
    config["demonstration"].Fail("no script is named '" + configured + "'");
  }
  params.first = {demonstration.empty() ? configured : demonstration, seed};
  config.Finish();
  return std::make_unique<Vtb>(bus, params);
}

}  // namespace cell
