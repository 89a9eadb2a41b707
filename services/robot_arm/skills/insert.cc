// insert(part, site): takes the part, unless it is held, and seats it at the
// site; on a thread it is tightened.
#include <cmath>

#include "services/robot_arm/contact/contact_stage.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "services/robot_arm/fastening.h"
#include "services/robot_arm/skill_run.h"
#include "services/robot_arm/skills/part_check.h"
#include "services/robot_arm/skills/skill_catalog.h"

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Made = StageRunner::Made;

const Site* SiteOf(const SkillRequest& request, const Arm& arm) {
  return arm.parts().FindSite(request.Argument("site"));
}

void AddTare(SkillRun& run) {
  run.Add({"tare"}, [&run]() -> Made {
    return std::make_unique<Tare>(run.arm().sensor());
  });
}

Made Contacting(SkillRun& run, ContactMotionMaker maker) {
  return std::make_unique<ContactStage>(run.arm().kinematics(),
                                        run.arm().sensor(), run.FramesAtSite(),
                                        std::move(maker), run.peak_force());
}

/// A part on its thread that is not tight yet: it is turned on from there.
Made GoOnScrewing(SkillRun& run, double pitch) {
  Arm& arm = run.arm();
  arm.sensor().Unload();
  const auto target = run.TargetAtSite();
  if (!target) return Reason{target.reason()};
  const Isometry3d X_SO = target->X_WO.inverse() *
                          arm.kinematics().GripperPose(arm.command().q) *
                          arm.held()->X_GO;
  const Eigen::Matrix3d& R = X_SO.linear();
  const double yaw = std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
  run.SetTarget(*target,
                target->X_WO * Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  const ScrewingParams params =
      arm.settings().screwing.GoingOnAt(X_SO.translation().z(), pitch);
  return Contacting(run, ScrewingMaker(params, pitch));
}

class Insert final : public Skill {
 public:
  std::string name() const override { return "insert"; }
  SkillTraits traits() const override {
    return {.needs_force_sensor = true, .leaves_room_after_failure = false};
  }
  std::vector<std::string> arguments() const override {
    return {"part", "site"};
  }

  std::optional<std::string> WhyNot(const SkillRequest& request,
                                    const Arm& arm) const override {
    if (auto why = WhyNoUseOf(request.Argument("part"), arm)) return why;
    const Site* site = SiteOf(request, arm);
    if (site == nullptr) {
      return "there is no site '" + request.Argument("site") + "'";
    }
    if (!arm.poses().contains(site->host)) {
      return "the pose of " + site->host + " is unknown";
    }
    return std::nullopt;
  }

  void Plan(SkillRun& run) const override {
    Arm& arm = run.arm();
    const Site& site = *SiteOf(run.request(), arm);
    const Thread* thread = arm.parts().FindThread(site.type);
    const auto target = [&run] {
      return run.TargetAtSite();
    };
    if (thread != nullptr && !arm.held() &&
        FindHoldingSite(run.request().Argument("part"), arm.parts(),
                        arm.poses()) == &site) {
      // Before anything touches the fingers: the thread carries the weight.
      AddTare(run);
      run.Grasp(target);
      run.Add({"turn", Contact::kParts}, [&run, pitch = thread->pitch] {
        return GoOnScrewing(run, pitch);
      });
      return run.LetGo();
    }
    if (!arm.held()) run.PickUp(target);
    run.Carry([&run]() -> Result<MotionRequest> {
      MotionRequest request = run.RequestOf(MotionRequest::Kind::kPlace);
      const auto place = run.TargetAtSite();
      if (!place) return Reason{place.reason()};
      request.target = *place;
      return request;
    });
    run.Add({"tare"}, [&run]() -> Made {
      run.arm().is_near = true;
      return std::make_unique<Tare>(run.arm().sensor());
    });
    run.Add({"seat", Contact::kParts}, [&run, type = site.type] {
      return Contacting(
          run, InsertionMaker(run.arm().settings().insertions.at(type)));
    });
    if (thread != nullptr) {
      run.Add({"turn", Contact::kParts}, [&run, pitch = thread->pitch] {
        return Contacting(run,
                          ScrewingMaker(run.arm().settings().screwing, pitch));
      });
    }
    run.LetGo();
  }
};

}  // namespace

std::unique_ptr<Skill> MakeInsert() {
  return std::make_unique<Insert>();
}

}  // namespace cell::robot_arm
