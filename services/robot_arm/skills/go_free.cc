// go_free(): from what a stop has left the arm at: lets go of what is held if
// a site holds it, draws back from what is near, goes home with an empty hand.
// All but the last is what every run begins with.
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

class GoFree final : public Skill {
 public:
  std::string name() const override { return "go_free"; }

  std::optional<std::string> WhyNot(const SkillRequest& /*request*/,
                                    const Arm& /*arm*/) const override {
    return std::nullopt;
  }

  void Plan(SkillRun& run) const override {
    // There may be no other request for long: the other arms need the room.
    if (!run.arm().held()) run.GoHome();
  }
};

}  // namespace

std::unique_ptr<Skill> MakeGoFree() {
  return std::make_unique<GoFree>();
}

}  // namespace cell::robot_arm
