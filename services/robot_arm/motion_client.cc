#include "services/robot_arm/motion_client.h"

#include <fmt/format.h>

#include <utility>

namespace cell::robot_arm {
namespace {

constexpr double kPeriod = 1;     // [s] then the request was lost
constexpr double kPatience = 20;  // [s] no answer until then: no planner

}  // namespace

int64_t MotionClient::Ask(MotionRequest request) {
  request.id = next_id_++;
  asked_.push_back(request);
  const int64_t id = request.id;
  open_.emplace(id, Open{std::move(request), std::nullopt});
  return id;
}

void MotionClient::Repeat(int64_t id) {
  const auto it = open_.find(id);
  if (it != open_.end() && !it->second.plan) {
    asked_.push_back(it->second.request);
  }
}

bool MotionClient::Put(const MotionPlan& plan) {
  const auto it = open_.find(plan.id);
  if (it == open_.end()) return false;
  it->second.plan = plan;
  return true;
}

const MotionPlan* MotionClient::Find(int64_t id) const {
  const auto it = open_.find(id);
  return it != open_.end() && it->second.plan ? &*it->second.plan : nullptr;
}

std::vector<MotionRequest> MotionClient::TakeRequests() {
  return std::exchange(asked_, {});
}

MotionInquiry::MotionInquiry(MotionClient& client, const MotionRequest& request)
    : client_(client), id_(client.Ask(request)) {}

MotionInquiry::State MotionInquiry::Step(double dt) {
  if (const MotionPlan* plan = client_.Find(id_)) {
    return *plan ? State::kFound : State::kNone;
  }
  waited_ += dt;
  if (waited_ > kPatience) return State::kNone;
  if (waited_ - asked_ >= kPeriod) {
    asked_ = waited_;
    client_.Repeat(id_);
  }
  return State::kWaiting;
}

std::string MotionInquiry::reason() const {
  const MotionPlan* plan = client_.Find(id_);
  return plan != nullptr
             ? plan->reason
             : fmt::format(
                   "the motion planner has not answered for {:.0f} s; is it "
                   "alive? (cell status)",
                   kPatience);
}

}  // namespace cell::robot_arm
