// An arm is stopped in the middle of its skills: it finds out what it holds and
// how that is fixed, goes free of it, and the cell completes what it was at.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "cell/arm_state_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/plan_t.hpp"
#include "services/cell/evaluations/stop_injector.h"
#include "tests/sim/assembling_cell.h"
#include "tests/sim/skill_watch.h"
#include "tests/test_folder.h"

namespace cell {

using namespace cli;

namespace {

constexpr double kStays = 0.5e-3;  // [m] that what is placed may move

/// The shipped deployment with arms that stop at a smaller force.
Deployment WithStopForce(const std::string& newtons) {
  Deployment deployment = ShippedDeployment();
  const auto dir = NewTestFolder();
  std::filesystem::copy(deployment.config_dir, dir);
  std::stringstream stream;
  stream << std::ifstream(dir / "vtb.yaml").rdbuf();
  std::string text = stream.str();
  const std::string key = "stop_force_n: 150";
  text.replace(text.find(key), key.size(), "stop_force_n: " + newtons);
  std::ofstream(dir / "vtb.yaml") << text;
  deployment.config_dir = dir;
  return deployment;
}

/// The operator resumes 1 s after each protective stop.
class Resumer {
 public:
  explicit Resumer(AssemblingCell& cell) {
    cell.On<arm_state_t>("ARM_STATE_RIGHT", [this, &cell](const auto& m) {
      const bool is_stopped = m.servo == arm_state_t::STOPPED;
      if (is_stopped && !was_stopped_) {
        ++num_stops_;
        command_mode_t resume{};
        resume.action = command_mode_t::RESUME;
        const int32_t tick = cell.tick() + 125;
        resume.deadline_utime = (tick + 10) * kTickUs;
        cell.bus().Schedule(
            SimBus::TimedCommand{tick, {"COMMAND_MODE", Bus::Encode(resume)}});
      }
      was_stopped_ = is_stopped;
    });
  }
  int num_stops() const { return num_stops_; }

 private:
  bool was_stopped_ = false;
  int num_stops_ = 0;
};

TEST(Stops, AScrewedInPartIsReleasedAfterAProtectiveStopAndNotCarriedAway) {
  AssemblingCell cell(1001, {}, WithStopForce("16"));
  const Resumer resumer(cell);
  const SkillWatch skills(cell);
  std::set<std::string> put_down;
  cell.On<plan_t>("PLAN", [&](const plan_t& plan) {
    for (const plan_step_t& step : plan.steps) {
      if (step.action == "PutDown") put_down.insert(step.arguments[0]);
    }
  });
  cell.Run();
  EXPECT_GT(resumer.num_stops(), 0) << "nothing has been tried";
  EXPECT_FALSE(put_down.contains("head"));
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_THAT(cell.Score().missing, testing::IsEmpty());
}

/// Every seed stops other stages in other ways (`cell eval stops`).
class StopsInEverySkill : public testing::TestWithParam<uint64_t> {};

TEST_P(StopsInEverySkill, MoveNoPlacedPartAndAreRecoveredFrom) {
  const auto success = SuccessCriterion::Load(ShippedDeployment());
  AssemblingCell cell(GetParam());
  StopInjector stops(cell.bus(), success, GetParam());
  cell.OnMessage([&](const Message& message) { stops.Put(message); });
  const SkillWatch skills(cell);
  cell.Run();
  EXPECT_GE(stops.stops().size(), 8u);
  for (const MadeStop& stop : stops.stops()) {
    EXPECT_LE(stop.moved, kStays)
        << stop.moved_part << " after a " << NameOf(stop.kind) << " of the "
        << stop.arm << " arm with " << stop.part << " at '" << stop.stage
        << "', tick " << stop.tick;
  }
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_THAT(cell.Score().missing, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Seeds, StopsInEverySkill, testing::Values(2));

}  // namespace
}  // namespace cell
