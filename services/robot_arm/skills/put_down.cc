// put_down(part): sets what is held down on a free place of the table.
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/part_check.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

class PutDown final : public Skill {
 public:
  std::string name() const override { return "put_down"; }
  std::vector<std::string> arguments() const override { return {"part"}; }

  std::optional<std::string> WhyNot(const SkillRequest& request,
                                    const Arm& arm) const override {
    return WhyNoUseOf(request.Argument("part"), arm);
  }

  void Plan(SkillRun& run) const override {
    if (!run.arm().held()) return run.GoHome();
    const CellLayout::PartsArea& area = run.arm().params().layout.parts_area;
    run.SetDown({area.centre - area.size / 2, area.centre + area.size / 2},
                false);
  }
};

}  // namespace

std::unique_ptr<Skill> MakePutDown() {
  return std::make_unique<PutDown>();
}

}  // namespace cell::robot_arm
