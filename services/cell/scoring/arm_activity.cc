#include "services/cell/scoring/arm_activity.h"

#include "common/skills/skill_arguments.h"

namespace cell::cli {

void ArmActivity::OnRequest(const asked_skill_t& request) {
  parts_[request.id] = ArgumentOf(request, "part");
}

/// A failed skill draws back with the part.
void ArmActivity::OnReport(const arm_report_t& report) {
  const bool had_contact = contact_ != arm_report_t::NO_CONTACT;
  const bool has_contact = report.contact != arm_report_t::NO_CONTACT;
  if (report.request >= 0) skill_ = report.request;
  if (!report.phase.empty()) {
    phase_ = report.phase;
    contact_ = report.contact;
  }
  held_ = report.held;
  if (has_contact && !had_contact) grasped_ = parts_[skill_];
  if (!held_.empty()) {
    grasped_ = held_;
  } else if (had_contact && !has_contact) {
    grasped_.clear();
  }
}

bool ArmActivity::IsHeldAmongParts() const {
  return contact_ == arm_report_t::PARTS ||
         contact_ == arm_report_t::PARTS_AND_TABLE;
}

bool ArmActivity::IsHeldAtTable() const {
  return contact_ == arm_report_t::PARTS_AND_TABLE;
}

}  // namespace cell::cli
