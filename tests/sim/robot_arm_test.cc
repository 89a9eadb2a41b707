// One arm at work in the testbed, asked by a stand-in for planner and
// supervisor.
#include "services/robot_arm/robot_arm.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <deque>
#include <iostream>

#include "cell/skill_result_t.hpp"
#include "common/bus/sim_bus.h"
#include "common/skills/skill_arguments.h"
#include "services/cell/scoring/assembly_score.h"
#include "services/cell/scoring/pose_history.h"
#include "services/motion_planner/motion_planner.h"
#include "services/tracker/tracker.h"
#include "services/vtb/vtb.h"
#include "tests/unit/changed_deployment.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
using namespace tracker;
using namespace vtb;

using namespace cli;
namespace {

struct RequestedSkill {
  std::string arm, skill;
  SkillArguments arguments;
};

// Asks for one skill after the other, and lets the arms move.
class Driver final : public Service {
 public:
  Driver(Bus& bus, std::deque<RequestedSkill> skills,
         std::vector<skill_result_t>* results)
      : bus_(bus), skills_(std::move(skills)), results_(results) {
    bus.Subscribe<skill_result_t>("SKILL_RESULT", [this](const auto& m) {
      results_->push_back(m);
      is_waiting_ = false;
      if (std::getenv("CELL_VERBOSE")) {
        std::cerr << 1e-6 * static_cast<double>(bus_.now()) << " s: " << m.id
                  << " outcome " << int{m.outcome} << " " << m.reason
                  << " peak " << m.peak_force << "\n";
      }
    });
    bus.Every(1, 0, [this] { OnTick(); });
  }

 private:
  void OnTick() {
    motion_permit_t permit{};
    permit.header.utime = bus_.now();
    permit.until_utime = bus_.now() + 40'000;
    permit.mode = motion_permit_t::EXECUTE;
    bus_.Publish("MOTION_PERMIT", permit);
    if (bus_.tick() < 60 || is_waiting_) return;
    if (skills_.empty()) {
      execution_t done{};
      done.header.utime = bus_.now();
      done.state = execution_t::DONE;
      if (!std::exchange(is_done_, true)) bus_.Publish("EXECUTION", done);
      return;
    }
    const RequestedSkill& next = skills_.front();
    asked_skill_t request{};
    request.header.utime = bus_.now();
    request.id = ++id_;
    request.deadline_utime = bus_.now() + 1'000'000;
    request.arm = next.arm;
    request.skill = next.skill;
    SetArguments(next.arguments, &request);
    bus_.Publish("SKILL_REQUEST", request);
    skills_.pop_front();
    is_waiting_ = true;
  }

  Bus& bus_;
  std::deque<RequestedSkill> skills_;
  std::vector<skill_result_t>* results_;
  bool is_waiting_ = false, is_done_ = false;
  int64_t id_ = 0;
};

struct Outcome {
  std::vector<skill_result_t> results;
  AssemblyScore score;
  double seconds = 0;
};

Outcome Assemble(uint64_t seed, std::deque<RequestedSkill> skills,
                 const Deployment& deployment = ShippedDeployment()) {
  Roster roster;
  roster.task = "cranfield";
  roster.entries = {{"vtb"},
                    {"tracker", 1, "tracker_ideal"},
                    {"robot_arm@left"},
                    {"robot_arm@right"},
                    {"motion_planner", 3},
                    {"driver"}};
  Outcome outcome;
  std::map<std::string, ServiceFactory> factories;
  factories["vtb"] = [&](Bus& bus) {
    return MakeVtb(bus, deployment, "execution", seed);
  };
  factories["tracker"] = [&](Bus& bus) {
    return MakeTracker(bus, deployment);
  };
  factories["motion_planner"] = [&](Bus& bus) {
    return motion_planner::MakeMotionPlanner(bus, deployment);
  };
  for (const char* arm : {"left", "right"}) {
    factories[std::string("robot_arm@") + arm] = [&, arm](Bus& bus) {
      return MakeRobotArm(bus, deployment, arm);
    };
  }
  factories["driver"] = [&](Bus& bus) {
    return std::make_unique<Driver>(bus, skills, &outcome.results);
  };
  SimBus bus(roster, std::move(factories));
  PoseHistory pose_history;
  while (bus.Step()) {
    for (const Message& message : bus.last_messages()) {
      if (message.channel != "TRUTH_POSES") continue;
      truth_poses_t poses{};
      poses.decode(message.bytes->data(), 0,
                   static_cast<int>(message.bytes->size()));
      pose_history.Put(std::move(poses));
    }
  }
  outcome.score = ScoreAssembly(pose_history.earlier(), pose_history.last(),
                                SuccessCriterion::Load(deployment));
  outcome.seconds = bus.last_tick().header.tick * kTickUs * 1e-6;
  return outcome;
}

RequestedSkill Insert(const std::string& part, const std::string& site) {
  return {"right", "insert", {{"part", part}, {"site", site}}};
}

const std::deque<RequestedSkill> kAll = {
    Insert("round_peg_1", "base.round_1"),
    Insert("round_peg_2", "base.round_2"),
    Insert("square_peg_1", "base.square_1"),
    Insert("square_peg_2", "base.square_2"),
    Insert("shaft", "base.shaft"),
    Insert("separator", "base.separator"),
    Insert("pendulum", "base.pendulum"),
    Insert("head", "pendulum.head"),
    Insert("face_plate", "base.face_plate"),
    {"right", "go_home", {}},
};

TEST(RobotArm, AssemblesEverythingOneAfterTheOther) {
  const char* seed = std::getenv("CELL_SEED");
  const Outcome outcome =
      Assemble(seed ? std::strtoull(seed, nullptr, 10) : 1001, kAll);
  ASSERT_EQ(outcome.results.size(), kAll.size());
  for (const skill_result_t& result : outcome.results) {
    EXPECT_EQ(result.outcome, skill_result_t::SUCCEEDED)
        << result.id << ": " << result.reason;
  }
  EXPECT_THAT(outcome.score.missing, testing::IsEmpty());
}

TEST(RobotArm, OneOfAnotherModelInsertsBesideOne) {
  const ChangedDeployment deployment(ShippedDeployment());
  deployment.Change("cell.yaml", "right:\n    model: ur5",
                    "right:\n    model: ur10e");
  const Outcome outcome =
      Assemble(1001,
               {Insert("round_peg_1", "base.round_1"),
                {"left", "present", {{"part", "square_peg_2"}}},
                Insert("square_peg_2", "base.square_2"),
                {"right", "go_home", {}}},
               deployment.get());
  ASSERT_EQ(outcome.results.size(), 4u);
  for (const skill_result_t& result : outcome.results) {
    EXPECT_EQ(result.outcome, skill_result_t::SUCCEEDED)
        << result.id << ": " << result.reason;
  }
  for (const std::string site : {"base.round_1", "base.square_2"}) {
    EXPECT_THAT(outcome.score.missing, testing::Not(testing::Contains(site)));
  }
}

}  // namespace
}  // namespace cell
