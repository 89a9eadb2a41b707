#include "services/cell/scoring/motion_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cell/episode_t.hpp"
#include "common/bus/decode.h"
#include "common/text/counted.h"

namespace cell::cli {

MotionCheck::MotionCheck(const CellLayout& layout, const PartTable& parts)
    : collisions_(layout, parts) {
  for (const ArmLayout& arm : layout.arms) {
    limits_.emplace(arm.name, LimitCheck(arm));
    activities_[arm.name];
    const std::string suffix = ChannelSuffix(arm.name);
    channels_["ARM_STATE_" + suffix] = {
        [this, arm = arm.name](const auto& m) { return OnState(arm, m); },
        true};
    channels_["ARM_SETPOINT_" + suffix] = {
        [this, arm = arm.name](const auto& m) {
          return OnSetpoint(arm, m);
        }};
    channels_["ARM_REPORT_" + suffix] = {[this, arm = arm.name](const auto& m) {
      return OnReport(arm, m);
    }};
  }
  channels_["SKILL_REQUEST"] = {[this](const auto& m) {
    return OnRequest(m);
  }};
  channels_["TRUTH_POSES"] = {[this](const auto& m) { return OnPoses(m); },
                              true};
  channels_["EPISODE"] = {[this](const auto& m) {
    return OnEpisode(m);
  }};
}

void MotionCheck::Put(const Message& message) {
  const auto it = channels_.find(message.channel);
  if (it == channels_.end()) return;
  Channel& channel = it->second;
  ++channel.num_messages;
  if (!channel.handler(message)) ++channel.num_unreadable;
}

std::vector<std::string> MotionCheck::Gaps() const {
  std::vector<std::string> gaps;
  for (const auto& [name, channel] : channels_) {
    if (channel.num_unreadable > 0) {
      gaps.push_back(fmt::format(
          "{}: {} of {} are damaged or of another type than this program's",
          name, channel.num_unreadable,
          Counted(channel.num_messages, "message")));
    } else if (channel.is_needed && channel.num_messages == 0) {
      gaps.push_back(name + ": the log holds no message");
    }
  }
  return gaps;
}

bool MotionCheck::OnState(const std::string& arm, const Message& message) {
  const auto state = Decode<arm_state_t>(message);
  if (!state) return false;
  constexpr double kStill = 0.01;  // [rad/s]
  is_moving_[arm] = !std::ranges::all_of(state->velocity, [](double velocity) {
    return std::abs(velocity) < kStill;
  });
  for (auto& breach : limits_.at(arm).OnState(*state)) {
    Add(arm, message.tick, std::move(breach));
  }
  return true;
}

bool MotionCheck::OnSetpoint(const std::string& arm, const Message& message) {
  const auto setpoint = Decode<arm_setpoint_t>(message);
  if (!setpoint) return false;
  for (auto& breach : limits_.at(arm).OnSetpoint(*setpoint)) {
    Add(arm, message.tick, std::move(breach));
  }
  return true;
}

bool MotionCheck::OnReport(const std::string& arm, const Message& message) {
  const auto report = Decode<arm_report_t>(message);
  if (report) activities_.at(arm).OnReport(*report);
  return report.has_value();
}

bool MotionCheck::OnRequest(const Message& message) {
  const auto request = Decode<asked_skill_t>(message);
  if (!request) return false;
  const auto activity = activities_.find(request->arm);
  if (activity != activities_.end()) activity->second.OnRequest(*request);
  return true;
}

bool MotionCheck::OnPoses(const Message& message) {
  const auto poses = Decode<truth_poses_t>(message);
  if (!poses) return false;
  for (const auto& touch : collisions_.Look(*poses, activities_)) {
    if (touch.is_by_person && !is_moving_[touch.arm]) continue;
    Add(touch.arm, message.tick,
        {Violation::Kind::kCollision, touch.first,
         fmt::format("touches {}", touch.second)});
  }
  return true;
}

/// Everything is put back to where it begins.
bool MotionCheck::OnEpisode(const Message& message) {
  const auto episode = Decode<episode_t>(message);
  if (!episode) return false;
  if (episode->phase != episode_t::START) return true;
  for (auto& [arm, limits] : limits_) limits.Restart();
  for (auto& [arm, activity] : activities_) activity = {};
  return true;
}

void MotionCheck::Add(const std::string& arm, int32_t tick,
                      LimitCheck::Breach breach) {
  const ArmActivity& activity = activities_.at(arm);
  const bool is_collision = breach.kind == Violation::Kind::kCollision;
  const std::string subject =
      is_collision ? breach.subject + " " + breach.value : breach.subject;
  if (!known_.emplace(arm, activity.skill(), breach.kind, subject).second) {
    return;
  }
  std::string what = breach.subject + " " + breach.value;
  if (activity.skill() >= 0) {
    what += fmt::format(", skill {}: {}", activity.skill(), activity.phase());
  }
  violations_.push_back({tick, arm, breach.kind, std::move(what)});
}

int MotionCheck::num_protective_stops() const {
  int num = 0;
  for (const auto& [arm, limits] : limits_) num += limits.num_stops();
  return num;
}

}  // namespace cell::cli
