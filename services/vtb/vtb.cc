#include "services/vtb/vtb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cell/alert_t.hpp"
#include "cell/attempt_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/truth_action_t.hpp"
#include "cell/truth_contacts_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/geometry/pose.h"

namespace cell::vtb {
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
constexpr int32_t kAskTicks = 500;
constexpr double kStill = 0.002;  // [m/s]

int StepsPerTick(double dt) {
  const double steps = kTick / dt;
  const double rounded = std::round(steps);
  if (!(rounded >= 1) || std::abs(steps - rounded) > 1e-9) {
    throw std::invalid_argument(
        fmt::format("{} s does not divide a tick of {} s", dt, kTick));
  }
  return static_cast<int>(rounded);
}

}  // namespace

Vtb::Vtb(Bus& bus, const Params& params)
    : bus_(bus),
      params_(params),
      steps_per_tick_(StepsPerTick(params.physics.dt)),
      world_(params.parts, params.layout, params.physics),
      demonstrations_(std::make_shared<Demonstrations>(params.demonstrations)),
      shapes_(ShapesOf(params.parts)),
      attendance_(params.operator_patience) {
  for (const ArmLayout& arm : params_.layout.arms) {
    arms_.push_back(
        std::make_unique<ArmDevice>(bus, arm, shapes_, params_.arms));
  }
  Prepare(params_.episodes.at(0));
  next_ = {kFirstTick, params_.episodes[0]};
  num_begun_ = 1;
  bus_.Subscribe<execution_t>(
      "EXECUTION", [this](const execution_t& m) { return OnExecution(m); });
  AnswerCommands<command_episode_t>(
      bus_, "COMMAND_EPISODE",
      [this](const command_episode_t& m) { return OnCommand(m); });
  bus_.Subscribe<command_fault_t>(
      "COMMAND_FAULT", [this](const command_fault_t& m) { return OnFault(m); });
  bus_.Subscribe<command_mode_t>(
      "COMMAND_MODE",
      [this](const command_mode_t& m) { return OnOperator(m.deadline_utime); });
  bus_.Subscribe<command_goal_t>(
      "COMMAND_GOAL",
      [this](const command_goal_t& m) { return OnOperator(m.deadline_utime); });
  bus_.Subscribe<operating_mode_t>(
      "MODE", [this](const operating_mode_t& m) { return OnMode(m); });
  bus_.Every(1, 0, [this] { OnTick(); });
}

void Vtb::Prepare(const Request& request) {
  episode_.demonstrator.emplace(demonstrations_, request.demonstration,
                                request.seed, world_);
  episode_.actions.emplace(demonstrations_);
  for (const auto& arm : arms_) arm->Reset(world_);
  episode_.request = request;
  episode_.script = &demonstrations_->scripts.at(request.demonstration);
  episode_.disturbance.reset();
  if (episode_.script->disturbance) {
    episode_.disturbance.emplace(demonstrations_, request.demonstration,
                                 request.seed, world_);
  }
  episode_.robot_state = execution_t::RUNNING;
  episode_.num_still = 0;
  attendance_.BeginEpisode();
}

bool Vtb::OnOperator(int64_t deadline_utime) {
  if (bus_.now() > deadline_utime) return false;
  attendance_.OnOperator();
  return true;
}

bool Vtb::OnMode(const operating_mode_t& message) {
  if (message.mode < motion_permit_t::IDLE ||
      message.mode > motion_permit_t::HOLD) {
    return false;
  }
  attendance_.OnMode(message.mode == motion_permit_t::HOLD, message.reason,
                     bus_.tick());
  return true;
}

CommandAnswer Vtb::OnCommand(const command_episode_t& message) {
  attendance_.OnOperator();
  switch (message.action) {
    case command_episode_t::END:
      return EndByCommand();
    case command_episode_t::START:
      return StartByCommand(
          {message.demonstration, static_cast<uint64_t>(message.seed)});
    default:
      return CommandAnswer::Refuse("its action is " +
                                   std::to_string(message.action) +
                                   ", neither START (0) nor END (1)");
  }
}

bool Vtb::OnFault(const command_fault_t& message) {
  const auto arm = std::ranges::find(arms_, message.arm,
                                     [](const auto& a) { return a->name(); });
  if (bus_.now() > message.deadline_utime || arm == arms_.end() ||
      message.kind != command_fault_t::PROTECTIVE_STOP) {
    return false;
  }
  (*arm)->Stop();
  return true;
}

CommandAnswer Vtb::EndByCommand() {
  const bool was_to_begin = std::exchange(next_, std::nullopt).has_value();
  if (episode_.is_running) {
    End();
    return CommandAnswer::Accept(fmt::format("episode {} ({}) has ended",
                                             episode_.id,
                                             episode_.request.demonstration));
  }
  bus_.EndRunIn(kGapTicks);
  return CommandAnswer::Accept(
      was_to_begin ? "the episode that was about to begin is cancelled"
                   : "no episode was running");
}

CommandAnswer Vtb::StartByCommand(const Request& request) {
  if (!demonstrations_->scripts.contains(request.demonstration)) {
    std::vector<std::string> names;
    for (const auto& [name, script] : demonstrations_->scripts)
      names.push_back(name);
    std::ranges::sort(names);
    return CommandAnswer::Refuse(
        fmt::format("the task has no demonstration '{}'; it has {}",
                    request.demonstration, fmt::join(names, ", ")));
  }
  const std::string before =
      episode_.is_running
          ? fmt::format("episode {} ({}) has ended; ", episode_.id,
                        episode_.request.demonstration)
          : "";
  if (episode_.is_running) End();
  next_ = {bus_.tick() + kGapTicks, request};
  bus_.EndRunIn(kForeverTicks - bus_.tick());
  return CommandAnswer::Accept(
      fmt::format("{}{} with seed {} begins at {:.2f} s", before,
                  request.demonstration, request.seed, kTick * next_->tick));
}

bool Vtb::OnExecution(const execution_t& message) {
  if (message.state < execution_t::RUNNING ||
      message.state > execution_t::STUCK) {
    return false;
  }
  episode_.robot_state = message.state;
  if (message.state == execution_t::STUCK && episode_.disturbance) {
    episode_.disturbance->AskFor(message.help_part, message.help_site);
  }
  if (episode_.disturbance) {
    episode_.disturbance->AskFor(RequestsOf(message));
  }
  return true;
}

void Vtb::OnTick() {
  if (bus_.tick() < kFirstTick) return;
  if (next_ && bus_.tick() >= next_->tick) {
    if (episode_.id > 0) Prepare(next_->request);
    next_.reset();
    ++episode_.id;
    episode_.is_running = true;
    episode_.start_tick = bus_.tick();
    PublishEpisode(episode_t::START);
  }
  episode_.demonstrator->Update(kTick, world_);
  if (episode_.disturbance) episode_.disturbance->Update(kTick, world_);
  for (const auto& arm : arms_) arm->Update(kTick, world_);
  world_.Run(steps_per_tick_);
  for (const auto& arm : arms_) arm->Publish(world_);
  if (bus_.tick() % params_.truth_period_ticks == 0) PublishTruth();
  if (!episode_.is_running) return;
  PublishActions();
  PublishAttempt();
  if (bus_.tick() % kRunningPeriod == 0) PublishEpisode(episode_t::RUNNING);
  if (!GiveUpWaiting() && IsOver()) EndOrGoOn();
}

/// Ends the run if its robot waits for an operator who is not there. Episodes
/// that were to follow would begin with the same hold.
bool Vtb::GiveUpWaiting() {
  if (episode_.script->agent == "person") return false;
  const auto why = attendance_.GiveUpReason(bus_.tick());
  if (!why) return false;
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::ERROR;
  alert.cause = alert_t::UNATTENDED;
  alert.text = *why;
  bus_.Publish("ALERT", alert);
  End();
  return true;
}

bool Vtb::HasAgentFinished() const {
  if (!episode_.demonstrator->is_done()) return false;
  if (episode_.script->agent == "person") return true;
  return episode_.robot_state != execution_t::RUNNING &&
         (!episode_.disturbance || episode_.disturbance->is_done()) &&
         std::ranges::all_of(arms_,
                             [](const auto& arm) { return arm->IsAtRest(); });
}

bool Vtb::IsOver() {
  if ((bus_.tick() - episode_.start_tick) * kTick >
      episode_.script->max_duration)
    return true;
  if (!HasAgentFinished()) {
    episode_.num_still = 0;
    return false;
  }
  ++episode_.num_still;
  // A service that has asked a question may still be answered.
  const bool is_asking = episode_.robot_state == execution_t::STUCK;
  if (episode_.num_still < (is_asking ? kAskTicks : kRestTicks)) return false;
  if (episode_.num_still >= kMaxRestTicks) return true;
  for (const Part& part : world_.table().parts()) {
    if (world_.SpeedOf(part.name) > kStill) return false;
  }
  return true;
}

void Vtb::EndOrGoOn() {
  End();
  if (num_begun_ >= params_.episodes.size()) return;
  next_ = {bus_.tick() + kGapTicks, params_.episodes[num_begun_++]};
  bus_.EndRunIn(kForeverTicks - bus_.tick());
}

void Vtb::End() {
  episode_.is_running = false;
  PublishEpisode(episode_t::END);
  bus_.EndRunIn(kGapTicks);
}

void Vtb::PublishEpisode(int8_t phase) {
  episode_t message{};
  message.header.utime = bus_.now();
  message.id = episode_.id;
  message.phase = phase;
  message.task = params_.task;
  message.goal = demonstrations_->goal;
  message.agent = episode_.script->agent;
  message.demonstration = episode_.request.demonstration;
  message.seed = static_cast<int64_t>(episode_.request.seed);
  bus_.Publish("EPISODE", message);
}

void Vtb::PublishTruth() {
  truth_poses_t poses{};
  poses.header.utime = bus_.now();
  const auto add = [&](const BodyPose& body) {
    poses.bodies.push_back({body.name, PoseToMessage(body.X_WB)});
  };
  std::ranges::for_each(world_.Bodies(), add);
  for (const auto& arm : arms_) std::ranges::for_each(arm->Bodies(), add);
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

void Vtb::PublishActions() {
  static_assert(static_cast<int>(LabeledAction::Kind::kTipped) ==
                truth_action_t::TIPPED);
  static_assert(static_cast<int>(LabeledAction::Mistake::kNotSeated) ==
                truth_action_t::NOT_SEATED);
  for (const LabeledAction& action :
       episode_.actions->Update(bus_.now(), world_)) {
    truth_action_t message{};
    message.header.utime = action.place_utime;
    message.kind = static_cast<int8_t>(action.kind);
    message.mistake = static_cast<int8_t>(action.mistake);
    message.part = action.part;
    message.site = action.site;
    message.hand = action.hand;
    message.pick_utime = action.pick_utime;
    bus_.Publish("TRUTH_ACTIONS", message);
  }
}

void Vtb::PublishAttempt() {
  const auto failed = episode_.demonstrator->TakeFailedAttempt();
  if (!failed || failed->attempt.rule->called.empty()) return;
  attempt_t message{};
  message.header.utime = bus_.now();
  message.begin_utime = bus_.now() - std::llround(1e6 * failed->duration);
  message.name = failed->attempt.rule->called;
  message.part = failed->attempt.part;
  message.site = failed->attempt.site;
  bus_.Publish("ATTEMPT", message);
}

}  // namespace cell::vtb
