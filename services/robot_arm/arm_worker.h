#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "services/robot_arm/arm_reading.h"
#include "services/robot_arm/contact/site_frames.h"
#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/motion_client.h"
#include "services/robot_arm/motions.h"
#include "services/robot_arm/or_reason.h"
#include "services/robot_arm/reachable_parts.h"
#include "services/robot_arm/right_of_way.h"
#include "services/robot_arm/scene_monitor.h"
#include "services/robot_arm/skill.h"
#include "services/robot_arm/skill_settings.h"
#include "services/robot_arm/skill_stage.h"
#include "services/robot_arm/tool_kinematics.h"

namespace cell::robot_arm {

/// One arm at work: does one skill at a time (section VIII-A), as stages one
/// after the other. Pure: what comes out is a function of what it was told.
class ArmWorker {
 public:
  struct Params {
    std::string arm;
    CellLayout layout;
    PartTable parts;
    SkillSettings settings;
  };
  /// What the supervisor allows.
  enum class Leave {
    kMove,    ///< go on
    kFinish,  ///< finish the skill that runs, begin none
    kFreeze   ///< stand still at once
  };

  explicit ArmWorker(const Params& params);
  ArmWorker(const ArmWorker&) = delete;
  ArmWorker& operator=(const ArmWorker&) = delete;

  /// Where parts are tracked; others are unknown. [X_WO]
  void See(const std::map<std::string, Eigen::Isometry3d>& poses);
  /// Points on persons' hands [in W].
  void SeeHands(std::vector<Eigen::Vector3d> points);
  void SeeOther(const std::string& arm, const ArmPosture& posture,
                bool is_gripping);

  /// What it asks of the planner of motions since the last call.
  std::vector<MotionRequest> TakeRequests() { return client_.TakeRequests(); }
  /// An answer; false if it does not wait for it.
  bool Put(const MotionPlan& plan) { return client_.Put(plan); }

  /// Takes the skill, or refuses it: then there is a result at once.
  void Begin(const SkillRequest& request, Leave leave);
  /// One tick of `dt` [s]: what the arm shall do next.
  ArmCommand Step(const ArmReading& reading, Leave leave, double dt);
  /// Of a skill that has ended or was refused since the last call.
  std::optional<SkillResult> TakeResult();

  /// Id of the skill that runs; -1: none.
  int64_t request() const { return request_ ? request_->id : -1; }
  const std::string& phase() const { return phase_; }
  /// Part in the gripper; empty: none, or nobody knows which. What is left in
  /// an idle gripper though a site holds it counts as placed: before the arm
  /// does anything else it lets go of it.
  std::string held() const;
  bool is_frozen() const { return is_frozen_; }
  /// Parts that it could take where they lie, sorted.
  std::vector<std::string> Reachable() const;

 private:
  /// A stage to come. It is made when its turn has come, for what is known
  /// then; text says why it cannot be, no stage that there is nothing to do.
  struct Todo {
    using Made = std::variant<std::unique_ptr<SkillStage>, std::string>;
    std::string phase;
    std::function<Made()> make;
    std::function<void()> then;  ///< when it is done; may be empty
  };

  using RequestMaker = std::function<OrReason<MotionRequest>()>;
  using Until = MoveFingers::Until;

  /// [m] that each finger opens at first, beside a seated part.
  static constexpr double kLetGoMargin = 0.008;
  static constexpr char kLetGo[] = "let go";  ///< a phase
  static constexpr char kPersonInTheWay[] = "a person's hand is in the way";

  std::optional<std::string> WhyNot(const SkillRequest& request) const;
  bool Waits(double dt);
  bool Heeds(RightOfWay::Advice advice, const std::string& reason);
  void GoAround();
  void TakeOtherWay(double dt);
  void Advance(double dt);
  bool BeginNext();
  void FinishFirst();
  void OnFailure(const std::string& reason);
  void End(SkillResult::Outcome outcome, const std::string& reason);

  // arm_worker_skills.cc
  void Add(const std::string& phase, std::function<Todo::Made()> make,
           std::function<void()> then = {});
  void AddWaitForHands(std::function<Eigen::Vector3d()> point,
                       std::function<void()> then = {});
  void PlanSkill();
  void PlanGoFree();
  void PlanInsert();
  void PlanTurnOn(const Thread& thread);
  void PlanPresent();
  void PlanPutDown();
  void PlanSetDown(const Eigen::AlignedBox2d& area, bool is_for_other_arm);
  /// Where the part is to go next tells which grasps are good.
  enum class Next { kUnknown, kToSite };
  void PlanGrasp(Next next);
  void PlanTake(Next next);
  void PlanCarry(const RequestMaker& place);
  void PlanLetGo();
  void PlanDrawBack();
  void PlanGoHome();

  MotionRequest Request(MotionRequest::Kind kind) const;
  OrReason<MotionRequest> GraspRequest(Next next) const;
  OrReason<MotionRequest> PlaceAtSiteRequest() const;
  Todo::Made Ask(const OrReason<MotionRequest>& request,
                 std::function<void(const MotionPlan&)> use);
  Todo::Made Transit(const Joints& q);
  Todo::Made Line(const Eigen::Isometry3d& X_WG);
  Todo::Made LineBy(const Eigen::Vector3d& way_W);
  Todo::Made Fingers(double opening, Until until);
  OrReason<PlaceTarget> TargetAtSite() const;
  SiteFrames FramesAtSite() const;
  const Site* SiteOfHeld() const;

  void ForgetHeld();
  void Hold(const std::string& part, const Eigen::Isometry3d& X_GO);
  void KnowHeld();

  Params params_;
  ToolKinematics kinematics_;
  ContactSensor sensor_;
  SceneMonitor monitor_;
  MotionClient client_;
  ReachableParts reachable_;
  ArmReading reading_;
  double still_ = 0;  // [s] that it has been at rest
  std::optional<ArmCommand> command_;
  std::optional<HeldPart> held_;
  std::optional<SkillRequest> request_;
  std::deque<Todo> todos_;
  std::unique_ptr<SkillStage> stage_;      // of the first of them
  std::unique_ptr<SkillStage> other_way_;  // the same, while it gets ready
  std::string phase_;
  GraspChoice grasp_;  // of the part that is taken ...
  Eigen::Isometry3d X_WO_grasp_ = Eigen::Isometry3d::Identity();  // ... there
  PlaceTarget target_;    // of the part that is put down
  PlaceChoice place_;     // there
  bool is_near_ = false;  // among things: it draws back before it turns away
  bool knows_place_ = false;  // whether it is near: not after a stop
  double peak_force_ = 0;
  bool has_moved_ = false;
  bool has_yielded_ = false;  // to a person: why it fails
  std::string failure_;       // that the arm recovers from
  std::optional<SkillResult> result_;
  RightOfWay way_of_others_, way_of_people_;
  bool is_frozen_ = false;
  double rate_ = 1;  // of time, as the arm starts again
};

}  // namespace cell::robot_arm
