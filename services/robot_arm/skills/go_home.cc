// go_home(): goes to where it is out of the way, with what it holds.
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

class GoHome final : public Skill {
 public:
  std::string name() const override { return "go_home"; }

  std::optional<std::string> WhyNot(const SkillRequest& /*request*/,
                                    const Arm& /*arm*/) const override {
    return std::nullopt;
  }

  void Plan(SkillRun& run) const override { run.GoHome(); }
};

}  // namespace

std::unique_ptr<Skill> MakeGoHome() {
  return std::make_unique<GoHome>();
}

}  // namespace cell::robot_arm
