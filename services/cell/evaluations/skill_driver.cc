#include "services/cell/evaluations/skill_driver.h"

#include <utility>

#include "cell/asked_skill_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/motion_permit_t.hpp"

namespace cell::cli {
namespace {

constexpr int32_t kFirstTick = 60;  // tracks and reports have come
constexpr int64_t kPermitUs = 5 * kTickUs;
constexpr int64_t kDeadlineUs = 1'000'000;

}  // namespace

SkillDriver::SkillDriver(Bus& bus, const Params& params)
    : bus_(bus), params_(params) {
  bus.Subscribe<skill_result_t>("SKILL_RESULT",
                                [this](const auto& m) { OnResult(m); });
  bus.Every(1, 0, [this] { OnTick(); });
}

void SkillDriver::OnResult(const skill_result_t& result) {
  if (result.id != id_) return;
  is_waiting_ = false;
  if (result.outcome != skill_result_t::REFUSED ||
      requested_.skill != "insert" || params_.helper.empty() ||
      std::exchange(has_helped_, true)) {
    return;
  }
  params_.tasks.push_front(requested_);
  params_.tasks.push_front(
      {params_.helper, "present", {{"part", requested_.arguments.at("part")}}});
}

void SkillDriver::OnTick() {
  motion_permit_t permit{};
  permit.header.utime = bus_.now();
  permit.until_utime = bus_.now() + kPermitUs;
  permit.mode = motion_permit_t::EXECUTE;
  bus_.Publish("MOTION_PERMIT", permit);
  if (bus_.tick() < kFirstTick || is_waiting_) return;
  if (!params_.tasks.empty()) {
    const Task task = params_.tasks.front();
    params_.tasks.pop_front();
    return Ask(task);
  }
  if (std::exchange(is_done_, true)) return;
  execution_t done{};
  done.header.utime = bus_.now();
  done.state = execution_t::DONE;
  bus_.Publish("EXECUTION", done);
}

void SkillDriver::Ask(const Task& task) {
  requested_ = task;
  is_waiting_ = true;
  asked_skill_t request{};
  request.header.utime = bus_.now();
  request.id = ++id_;
  request.deadline_utime = bus_.now() + kDeadlineUs;
  request.arm = task.arm;
  request.skill = task.skill;
  SetArguments(task.arguments, &request);
  bus_.Publish("SKILL_REQUEST", request);
}

}  // namespace cell::cli
