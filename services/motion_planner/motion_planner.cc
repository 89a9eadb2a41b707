#include "services/motion_planner/motion_planner.h"

#include "cell/operating_mode_t.hpp"
#include "common/arms/motion_messages.h"

namespace cell::motion_planner {

MotionPlanner::MotionPlanner(Bus& bus, MotionSearch::Params params)
    : bus_(bus), alerts_(bus), search_(std::move(params)) {
  bus.Subscribe<motion_request_t>(
      "MOTION_REQUEST", [this](const auto& m) { return OnRequest(m); });
  // Activates it now and then, so that its STATUS shows that it runs.
  bus.Subscribe<operating_mode_t>(
      "MODE", [](const operating_mode_t&) {}, 1);
  bus.Every(1, 0, [this] { Answer(); });
}

bool MotionPlanner::OnRequest(const motion_request_t& message) {
  auto request =
      FromMessage(message, search_.params().parts, search_.params().layout);
  if (!request) return alerts_.Reject("MOTION_REQUEST", request.reason());
  const bool is_reach = request->kind == MotionRequest::Kind::kReach;
  const std::pair slot(request->arm, is_reach);
  waiting_[slot] = {message.header.utime, *std::move(request)};
  return true;
}

void MotionPlanner::Answer() {
  for (const auto& [slot, waiting] : std::exchange(waiting_, {})) {
    bus_.Publish("MOTION_PLAN",
                 ToMessage(search_.Find(waiting.request), waiting.utime));
  }
}

std::unique_ptr<Service> MakeMotionPlanner(Bus& bus,
                                           const Deployment& deployment) {
  const Config skills = deployment.OfTask("skills.yaml");
  return std::make_unique<MotionPlanner>(
      bus, MotionSearch::Params{
               CellLayout::FromConfig(deployment.OfTask("cell.yaml")),
               PartTable::FromConfig(deployment.OfTask("parts.yaml")),
               MotionSettings::FromConfig(skills["motion"]),
               FingerSettings::FromConfig(skills["fingers"])});
}

}  // namespace cell::motion_planner
