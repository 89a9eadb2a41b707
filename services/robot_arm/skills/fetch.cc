// fetch(part): takes the part and waits.
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/part_check.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

class Fetch final : public Skill {
 public:
  std::string name() const override { return "fetch"; }
  std::vector<std::string> arguments() const override { return {"part"}; }

  std::optional<std::string> WhyNot(const SkillRequest& request,
                                    const Arm& arm) const override {
    return WhyNoUseOf(request.Argument("part"), arm);
  }

  void Plan(SkillRun& run) const override { run.PickUp(); }
};

}  // namespace

std::unique_ptr<Skill> MakeFetch() {
  return std::make_unique<Fetch>();
}

}  // namespace cell::robot_arm
