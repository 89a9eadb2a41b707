// present(part): sets the part down upright where another arm can take it.
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/part_check.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

class Present final : public Skill {
 public:
  std::string name() const override { return "present"; }
  SkillTraits traits() const override {
    return {.may_run_beside = true, .hands_over = true};
  }
  std::vector<std::string> arguments() const override { return {"part"}; }

  std::optional<std::string> WhyNot(const SkillRequest& request,
                                    const Arm& arm) const override {
    return WhyNoUseOf(request.Argument("part"), arm);
  }

  void Plan(SkillRun& run) const override {
    if (!run.arm().held()) run.PickUp();
    run.SetDown(run.arm().layout().exchange, true);
  }
};

}  // namespace

std::unique_ptr<Skill> MakePresent() {
  return std::make_unique<Present>();
}

}  // namespace cell::robot_arm
