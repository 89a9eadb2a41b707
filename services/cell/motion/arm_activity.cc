#include "services/cell/motion/arm_activity.h"

#include <set>

namespace cell::cli {
namespace {

using Phases = std::set<std::string>;

// Phases as ARM_REPORT names them. A failed skill draws back with the part.
constexpr char kClose[] = "close";
constexpr char kDrawBack[] = "draw back";
const Phases kAtTable = {kClose, "lift", "set down", "let go", kDrawBack};
const Phases kAmongParts = {kClose,     "lift",   "seat",   "turn",
                            "set down", "let go", kDrawBack};

}  // namespace

void ArmActivity::Take(const skill_request_t& request) {
  parts_[request.id] = request.part;
}

void ArmActivity::Take(const arm_report_t& report) {
  const bool was_drawing_back = phase_ == kDrawBack;
  if (report.request >= 0) skill_ = report.request;
  const bool is_drawing_back = report.phase == kDrawBack;
  if (!report.phase.empty()) phase_ = report.phase;
  held_ = report.held;
  if (report.phase == kClose) grasped_ = parts_[skill_];
  if (!held_.empty()) {
    grasped_ = held_;
  } else if (was_drawing_back && !is_drawing_back) {
    grasped_.clear();
  }
}

bool ArmActivity::IsHeldAmongParts() const {
  return kAmongParts.contains(phase_);
}

bool ArmActivity::IsHeldAtTable() const {
  return kAtTable.contains(phase_);
}

}  // namespace cell::cli
