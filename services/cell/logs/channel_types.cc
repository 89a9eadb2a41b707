#include "services/cell/logs/channel_types.h"

#include <map>

#include "cell/ack_t.hpp"
#include "cell/action_record_t.hpp"
#include "cell/alert_t.hpp"
#include "cell/answer_t.hpp"
#include "cell/arm_report_t.hpp"
#include "cell/arm_setpoint_t.hpp"
#include "cell/arm_state_t.hpp"
#include "cell/arm_stop_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/attempt_t.hpp"
#include "cell/command_confirm_t.hpp"
#include "cell/command_episode_t.hpp"
#include "cell/command_fault_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/command_name_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/experience_t.hpp"
#include "cell/health_t.hpp"
#include "cell/hello_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/library_request_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/motion_plan_t.hpp"
#include "cell/motion_request_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/relation_layers_t.hpp"
#include "cell/rgbd_frame_t.hpp"
#include "cell/sense_request_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/status_t.hpp"
#include "cell/step_t.hpp"
#include "cell/store_answer_t.hpp"
#include "cell/tick_t.hpp"
#include "cell/tracks_t.hpp"
#include "cell/truth_action_t.hpp"
#include "cell/truth_contacts_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "cell/wrench_t.hpp"

namespace cell::cli {
namespace {

template <class M>
ChannelType Of() {
  return {M::getTypeName(), M::getHash()};
}

const std::map<std::string, ChannelType>& Table() {
  static const std::map<std::string, ChannelType> table = {
      {"ACK", Of<ack_t>()},
      {"ACTION", Of<recognised_action_t>()},
      {"ACTION_RECORD", Of<action_record_t>()},
      {"ALERT", Of<alert_t>()},
      {"ANSWER", Of<answer_t>()},
      {"ARM_REPORT_LEFT", Of<arm_report_t>()},
      {"ARM_REPORT_RIGHT", Of<arm_report_t>()},
      {"ARM_SETPOINT_LEFT", Of<arm_setpoint_t>()},
      {"ARM_SETPOINT_RIGHT", Of<arm_setpoint_t>()},
      {"ARM_STATE_LEFT", Of<arm_state_t>()},
      {"ARM_STATE_RIGHT", Of<arm_state_t>()},
      {"ARM_STOP_LEFT", Of<arm_stop_t>()},
      {"ARM_STOP_RIGHT", Of<arm_stop_t>()},
      {"ATTEMPT", Of<attempt_t>()},
      {"COMMAND_EPISODE", Of<command_episode_t>()},
      {"COMMAND_FAULT", Of<command_fault_t>()},
      {"COMMAND_CONFIRM", Of<command_confirm_t>()},
      {"COMMAND_GOAL", Of<command_goal_t>()},
      {"COMMAND_LIBRARY", Of<command_library_t>()},
      {"COMMAND_MODE", Of<command_mode_t>()},
      {"COMMAND_NAME", Of<command_name_t>()},
      {"EPISODE", Of<episode_t>()},
      {"EXECUTION", Of<execution_t>()},
      {"EXPERIENCE", Of<experience_t>()},
      {"EXPERIENCE_REQUEST", Of<experience_t>()},
      {"FRAME_1", Of<rgbd_frame_t>()},
      {"FRAME_2", Of<rgbd_frame_t>()},
      {"FRAME_3", Of<rgbd_frame_t>()},
      {"HEALTH", Of<health_t>()},
      {"HELLO", Of<hello_t>()},
      {"KEY_FRAME", Of<key_frame_t>()},
      {"LIBRARY_REQUEST", Of<library_request_t>()},
      {"MODE", Of<operating_mode_t>()},
      {"MOTION_PERMIT", Of<motion_permit_t>()},
      {"MOTION_PLAN", Of<motion_plan_t>()},
      {"MOTION_REQUEST", Of<motion_request_t>()},
      {"PLAN", Of<plan_t>()},
      {"PREDICATES", Of<predicates_t>()},
      {"RELATION_LAYERS", Of<relation_layers_t>()},
      {"SENSE_REQUEST", Of<sense_request_t>()},
      {"SKILL_REQUEST", Of<asked_skill_t>()},
      {"SKILL_RESULT", Of<skill_result_t>()},
      {"STATUS", Of<status_t>()},
      {"STEP", Of<step_t>()},
      {"STORED", Of<store_answer_t>()},
      {"STORE_REQUEST", Of<action_record_t>()},
      {"TICK", Of<tick_t>()},
      {"TRACKS", Of<tracks_t>()},
      {"TRUTH_ACTIONS", Of<truth_action_t>()},
      {"TRUTH_CONTACTS", Of<truth_contacts_t>()},
      {"TRUTH_POSES", Of<truth_poses_t>()},
      {"WRENCH_RIGHT", Of<wrench_t>()},
  };
  return table;
}

}  // namespace

std::optional<ChannelType> TypeOfChannel(const std::string& channel) {
  const auto it = Table().find(channel);
  if (it == Table().end()) return std::nullopt;
  return it->second;
}

}  // namespace cell::cli
