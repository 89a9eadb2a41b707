#include "services/cell/evaluations/stop_injector.h"

#include <set>
#include <utility>

#include "cell/command_fault_t.hpp"
#include "cell/command_mode_t.hpp"
#include "common/bus/decode.h"
#include "services/cell/scoring/assembly_score.h"

namespace cell::cli {

namespace {

constexpr int32_t kCalm = 125;          // [ticks] from a stop's end to the next
constexpr int32_t kCommandTicks = 10;   // how long a command is valid
constexpr int kMostStopsOfTurning = 3;  // of one and the same skill

/// Phases in which an arm handles parts, so that these may move.
bool IsAtWork(const arm_report_t& report) {
  static const std::set<std::string> phases = {"reach", "close", "tare",
                                               "seat",  "turn",  "set down"};
  return report.request >= 0 && phases.contains(report.phase);
}

StoppedSkill SkillOf(const asked_skill_t& request, const PartTable& parts) {
  if (request.skill != "insert") return StoppedSkill::kSetDown;
  const Site* site = parts.FindSite(ArgumentOf(request, "site"));
  return site != nullptr && parts.FindThread(site->type) != nullptr
             ? StoppedSkill::kInsertTurning
             : StoppedSkill::kInsert;
}

}  // namespace

void StopInjector::Put(const Message& message) {
  if (message.channel == "SKILL_REQUEST") {
    if (auto request = Decode<asked_skill_t>(message)) {
      requests_[request->id] = *std::move(request);
    }
  } else if (message.channel.starts_with("ARM_REPORT_")) {
    if (const auto report = Decode<arm_report_t>(message)) OnReport(*report);
  } else if (message.channel == "TRUTH_POSES") {
    if (const auto poses = Decode<truth_poses_t>(message)) OnPoses(*poses);
  }
}

void StopInjector::OnReport(const arm_report_t& report) {
  Skill& skill = skills_[report.arm];
  const bool is_new = skill.phase != report.phase;
  skill.phase = report.phase;
  const int32_t now = bus_.last_tick().header.tick;
  if (!stops_.empty()) {
    MadeStop& last = stops_.back();
    if (now <= last.tick && last.arm == report.arm) last.stage = report.phase;
    if (now > last.end_tick && last.arm == report.arm && IsAtWork(report)) {
      is_watching_ = false;
    }
    if (now < last.end_tick + kCalm) return;
  }
  if (report.request != skill.request) {
    skill.request = report.request;
    skill.choice.reset();
    const auto request = requests_.find(report.request);
    if (request != requests_.end()) Choose(request->second, skill);
  }
  if (!is_new || !skill.choice ||
      !report.phase.starts_with(skill.choice->stage)) {
    return;
  }
  const StopChoice choice = *std::exchange(skill.choice, std::nullopt);
  Make(choice, report.arm, ArgumentOf(requests_.at(report.request), "part"));
}

void StopInjector::Choose(const asked_skill_t& request, Skill& skill) {
  const std::string part = ArgumentOf(request, "part");
  if (part.empty()) return;
  const StoppedSkill kind = SkillOf(request, success_.parts);
  int& num_tried = num_tried_[{request.arm, request.skill, part}];
  if (num_tried >=
      (kind == StoppedSkill::kInsertTurning ? kMostStopsOfTurning : 1))
    return;
  ++num_tried;
  skill.choice = ChooseStop(kind, seed_, num_of_[kind]++);
}

void StopInjector::Command(int32_t tick, const std::string& channel,
                           auto message) {
  message.deadline_utime = (tick + kCommandTicks) * kTickUs;
  bus_.Schedule(SimBus::TimedCommand{tick, {channel, Bus::Encode(message)}});
}

void StopInjector::Make(const StopChoice& choice, const std::string& arm,
                        const std::string& part) {
  const int32_t tick = bus_.last_tick().header.tick + 1 + choice.delay;
  const int32_t end = tick + choice.duration;
  stops_.push_back(
      {choice.kind, tick, end, arm, part, skills_.at(arm).phase, "", 0});
  is_watching_ = false;
  placed_.clear();
  if (choice.kind == StopKind::kDeath) {
    bus_.Schedule(SimBus::Outage{"robot_arm@" + arm, tick, end});
    return;
  }
  if (choice.kind == StopKind::kHold) {
    command_mode_t hold{};
    hold.action = command_mode_t::HOLD;
    Command(tick, "COMMAND_MODE", hold);
  } else {
    command_fault_t fault{};
    fault.arm = arm;
    fault.kind = command_fault_t::PROTECTIVE_STOP;
    Command(tick, "COMMAND_FAULT", fault);
  }
  command_mode_t resume{};
  resume.action = command_mode_t::RESUME;
  Command(end, "COMMAND_MODE", resume);
}

void StopInjector::OnPoses(const truth_poses_t& poses) {
  looks_.Put(poses);
  const auto truth = TruthFromMessage(poses);
  if (stops_.empty() || !truth) return;
  MadeStop& stop = stops_.back();
  const int32_t now = bus_.last_tick().header.tick;
  if (!is_watching_ && placed_.empty() && now >= stop.tick &&
      now <= stop.end_tick) {
    Remember(*truth);
  }
  if (!is_watching_) return;
  for (const auto& [part, p_W] : placed_) {
    const auto pose = truth->poses.find(part);
    if (pose == truth->poses.end()) continue;
    const double moved = (pose->second.translation() - p_W).norm();
    if (moved <= stop.moved) continue;
    stop.moved = moved;
    stop.moved_part = part;
  }
}

/// What is placed as the stop is made.
void StopInjector::Remember(const TruthPoses& truth) {
  is_watching_ = true;
  if (!looks_.has_both()) return;
  const AssemblyScore score =
      ScoreAssembly(looks_.earlier(), looks_.last(), success_);
  for (const std::string& part : score.placed) {
    placed_[part] = truth.poses.at(part).translation();
  }
}

}  // namespace cell::cli
