#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "cell/command_episode_t.hpp"
#include "cell/command_fault_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/config/deployment.h"
#include "services/vtb/action_labeler.h"
#include "services/vtb/arm_device.h"
#include "services/vtb/attendance.h"
#include "services/vtb/demonstrator.h"
#include "services/vtb/disturbance_model.h"
#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// The virtual testbed (section IV): owner of time. Steps the world, the arms
/// and the scripted person each tick, publishes where everything is and what
/// touches, and begins and ends episodes, on its own or at an operator's
/// command.
class Vtb : public Service {
 public:
  /// An episode.
  struct Request {
    std::string demonstration;  ///< name of a script
    uint64_t seed = 0;
  };
  struct Params {
    std::string task;  ///< name of its folder
    PartTable parts;
    CellLayout layout;
    Demonstrations demonstrations;
    PhysicsParams physics;
    ArmDevice::Params arms;
    /// [ticks] that a hold waits for the operator; nothing: for ever.
    std::optional<int32_t> operator_patience;
    std::vector<Request> episodes;   ///< the first begins at tick 1
    int32_t truth_period_ticks = 4;  ///< of TRUTH_*
  };

  /// @throws std::invalid_argument if there is no such script or
  /// a tick is not a whole number of the physics' steps.
  Vtb(Bus& bus, const Params& params);

 private:
  /// That runs, or ran last; before the first one, that.
  struct Episode {
    int64_t id = 0;  ///< counts from 1
    Request request;
    const Script* script = nullptr;  ///< of the demonstrations
    std::optional<Demonstrator> demonstrator;
    std::optional<DisturbanceModel> disturbance;
    std::optional<ActionLabeler> actions;
    bool is_running = false;
    int32_t start_tick = 0;
    int8_t robot_state = execution_t::RUNNING;
    int32_t num_still = 0;  ///< ticks since all were done
  };
  struct Appointment {
    int32_t tick;
    Request request;
  };

  CommandAnswer OnCommand(const command_episode_t& message);
  bool OnFault(const command_fault_t& message);
  bool OnOperator(int64_t deadline_utime);
  bool OnMode(const operating_mode_t& message);
  bool OnExecution(const execution_t& message);
  void OnTick();
  void Prepare(const Request& request);
  CommandAnswer EndByCommand();
  CommandAnswer StartByCommand(const Request& request);
  void EndOrGoOn();
  void PublishEpisode(int8_t phase);
  void PublishTruth();
  void PublishActions();
  void PublishAttempt();
  void End();
  bool GiveUpWaiting();
  bool IsOver();
  bool HasAgentFinished() const;

  Bus& bus_;
  Params params_;
  int steps_per_tick_;
  World world_;
  std::shared_ptr<const Demonstrations> demonstrations_;
  std::vector<PartShape> shapes_;
  std::vector<std::unique_ptr<ArmDevice>> arms_;
  Attendance attendance_;
  Episode episode_;
  size_t num_begun_ = 0;  // of the episodes that were planned
  std::optional<Appointment> next_;
};

/// By deploy/config/vtb.yaml and the task's files; `demonstration` names the
/// script that is shown first ("": the configured one).
std::unique_ptr<Service> MakeVtb(Bus& bus, const Deployment& deployment,
                                 const std::string& demonstration,
                                 uint64_t seed);

}  // namespace cell::vtb
