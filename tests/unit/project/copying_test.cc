// What others point to stays where it is: an object whose members refer to one
// another, which has subscribed to something, or which is used through its base
// class, is neither copied nor moved.
#include <gtest/gtest.h>

#include <type_traits>

#include "common/bus/clock_host.h"
#include "common/bus/follow_node.h"
#include "common/bus/lcm_port.h"
#include "common/bus/live_node.h"
#include "common/bus/lockstep_node.h"
#include "common/bus/sim_bus.h"
#include "common/sec/chain_similarity.h"
#include "common/sec/sec_library.h"
#include "common/text/printable_output.h"
#include "services/camera_set/frame_device.h"
#include "services/cell/evaluations/evaluation.h"
#include "services/cell/running/operator_port.h"
#include "services/cell/scoring/motion_check.h"
#include "services/library/action_store.h"
#include "services/motion_planner/request_search.h"
#include "services/planner/decision_state.h"
#include "services/planner/execution/execution_state.h"
#include "services/planner/solver.h"
#include "services/robot_arm/arm_worker.h"
#include "services/robot_arm/contact/contact_stage.h"
#include "services/vtb/arm_device.h"
#include "services/vtb/hand_stage.h"
#include "services/vtb/world.h"

namespace cell {
namespace {

template <class... T>
constexpr bool kStayInPlace = ((!std::is_copy_constructible_v<T> &&
                                !std::is_copy_assignable_v<T> &&
                                !std::is_move_constructible_v<T> &&
                                !std::is_move_assignable_v<T>)&&...);

// What keeps a Bus refers to it.
static_assert(kStayInPlace<Bus, Service, Stepper, ClockHost, LockstepNode,
                           LiveNode, FollowNode, SimBus, LcmPort>);
static_assert(kStayInPlace<cli::OperatorPort, cli::MotionCheck, vtb::ArmDevice,
                           PrintableOutput>);
// Members that refer to members.
static_assert(
    kStayInPlace<robot_arm::ArmWorker, robot_arm::Arm, robot_arm::ContactSensor,
                 robot_arm::SceneMonitor, robot_arm::ReachableParts,
                 robot_arm::MotionClient, robot_arm::MotionInquiry>);
static_assert(kStayInPlace<robot_arm::SkillRun>);  // its stages refer to it
static_assert(
    kStayInPlace<motion_planner::MotionSearch, motion_planner::RequestSearch>);
static_assert(kStayInPlace<vtb::Hands, vtb::PartBodies>);
// Its parts are on the heap: it can be moved.
static_assert(!std::is_copy_constructible_v<vtb::World> &&
              std::is_move_constructible_v<vtb::World>);
// Bases: a copy would be cut to them.
static_assert(
    kStayInPlace<ChainSimilarity, SecLibrary, SecModel, camera_set::FrameDevice,
                 library::ActionStore, cli::Evaluation>);
static_assert(kStayInPlace<planner::DecisionState, planner::ExecutionState,
                           planner::Solver>);
static_assert(
    kStayInPlace<robot_arm::Skill, robot_arm::SkillStage, robot_arm::MoveOnLine,
                 robot_arm::ContactStage, robot_arm::MotionReference,
                 robot_arm::Termination, vtb::HandStage>);

struct Plain {};
static_assert(!kStayInPlace<Plain> && !kStayInPlace<Bus, Plain>);

TEST(Copying, IsCheckedWhenThisIsCompiled) {}

}  // namespace
}  // namespace cell
