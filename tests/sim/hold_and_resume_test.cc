// The operator holds the cell while it assembles, and an arm stops by itself:
// the cell stands, reports the reason, and goes on after a resume.
#include <gmock/gmock.h>

#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cell/arm_setpoint_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "tests/sim/assembling_cell.h"
#include "tests/sim/motion_watch.h"
#include "tests/sim/skill_watch.h"

namespace cell {
namespace {

constexpr uint64_t kSeed = 3;
constexpr int32_t kHoldTicks = 250;  // 2 s

/// The operator at the control port.
void Command(AssemblingCell& cell, int32_t tick, int8_t action,
             int64_t deadline_utime) {
  command_mode_t command{};
  command.action = action;
  command.deadline_utime = deadline_utime;
  cell.bus().Schedule(
      SimBus::TimedCommand{tick, {"COMMAND_MODE", Bus::Encode(command)}});
}
void Command(AssemblingCell& cell, int32_t tick, int8_t action) {
  Command(cell, tick, action, (tick + 10) * kTickUs);
}

/// Calls `then` when the right arm begins the `num`-th phase of this name.
void WhenPhase(AssemblingCell& cell, const std::string& phase, int num,
               const std::function<void()>& then) {
  cell.On<arm_report_t>(
      "ARM_REPORT_RIGHT",
      [=, last = std::string(), left = num](const auto& m) mutable {
        const bool is_new = last != m.phase;
        last = m.phase;
        if (is_new && m.phase == phase && --left == 0) then();
      });
}

TEST(HoldAndResume, AnOperatorsHoldStopsTheArmsAtOnceAndTheSkillGoesOn) {
  AssemblingCell cell(kSeed);
  const MotionWatch motion(cell);
  const SkillWatch skills(cell);
  std::vector<int32_t> holds;
  std::vector<operating_mode_t> modes;
  cell.On<operating_mode_t>("MODE", [&](const auto& m) { modes.push_back(m); });
  const auto hold = [&](int32_t delay) {
    const int32_t tick = cell.tick() + delay;
    holds.push_back(tick);
    Command(cell, tick, command_mode_t::HOLD);
    Command(cell, tick + kHoldTicks, command_mode_t::RESUME);
  };
  WhenPhase(cell, "reach", 1, [&] { hold(30); });
  WhenPhase(cell, "carry", 1, [&] { hold(60); });
  WhenPhase(cell, "seat", 1, [&] { hold(100); });
  WhenPhase(cell, "turn", 1, [&] { hold(60); });
  // One that has come too late is not executed.
  WhenPhase(cell, "carry", 2, [&] {
    Command(cell, cell.tick() + 60, command_mode_t::HOLD,
            cell.tick() * kTickUs);
  });
  // For each tick of the run: whether a set-point of the right arm moved.
  std::map<int32_t, bool> is_moving;
  std::optional<arm_setpoint_t> last;
  cell.On<arm_setpoint_t>("ARM_SETPOINT_RIGHT", [&](const auto& m) {
    is_moving[m.header.tick] = last && m.position != last->position;
    last = m;
  });
  cell.Run();

  std::cout << "hold: " << motion.num_stops() << " stops, frozen after "
            << motion.max_freeze_ticks() << " ticks, at rest after "
            << motion.max_rest_ticks() << "\n";
  ASSERT_EQ(holds.size(), 4u);
  for (const int32_t at : holds) {
    EXPECT_TRUE(is_moving.at(at)) << "nothing was under way at " << at;
    for (int32_t tick = at + MotionWatch::kFreezeTicks; tick < at + kHoldTicks;
         ++tick) {
      EXPECT_FALSE(is_moving.at(tick)) << "held at " << at << ", " << tick;
    }
    bool goes_on = false;
    for (int32_t tick = at + kHoldTicks; tick < at + kHoldTicks + 25; ++tick) {
      goes_on |= is_moving.at(tick);
    }
    EXPECT_TRUE(goes_on) << "not resumed after " << at;
  }
  int num_held = 0;
  for (size_t i = 1; i < modes.size(); ++i) {
    const bool is_hold = modes[i].mode == motion_permit_t::HOLD;
    num_held += is_hold && modes[i - 1].mode != motion_permit_t::HOLD;
    EXPECT_EQ(modes[i].reason, is_hold ? "the operator holds the cell" : "");
  }
  EXPECT_EQ(num_held, 4);
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_THAT(cell.Score().missing, testing::IsEmpty());
  for (const skill_result_t& result : skills.results()) {
    EXPECT_EQ(result.outcome, skill_result_t::SUCCEEDED)
        << result.id << ": " << result.reason;
  }
}

TEST(HoldAndResume, AHoldOutlivesTheSupervisor) {
  AssemblingCell cell(kSeed);
  std::optional<int32_t> held;
  WhenPhase(cell, "carry", 1, [&] {
    held = cell.tick() + 30;
    Command(cell, *held, command_mode_t::HOLD);
    cell.bus().Schedule({"supervisor", *held + 50, *held + 90});
    Command(cell, *held + kHoldTicks, command_mode_t::RESUME);
  });
  std::optional<arm_setpoint_t> last;
  std::optional<int32_t> moved_early, moved_again;
  cell.On<arm_setpoint_t>("ARM_SETPOINT_RIGHT", [&](const auto& m) {
    const bool is_moving = last && m.position != last->position;
    last = m;
    if (!held || !is_moving) return;
    const int32_t since = m.header.tick - *held;
    if (since >= MotionWatch::kFreezeTicks && since < kHoldTicks) {
      moved_early = since;
    }
    if (since >= kHoldTicks && !moved_again) moved_again = since;
  });
  cell.Run(3000);
  ASSERT_TRUE(held.has_value());
  EXPECT_FALSE(moved_early.has_value()) << *moved_early;
  ASSERT_TRUE(moved_again.has_value());
  EXPECT_LE(*moved_again, kHoldTicks + 25);
}

/// Sends an arm deeper than its own service does, for a moment.
class Saboteur final : public Service {
 public:
  explicit Saboteur(Bus& bus) : bus_(bus) {
    bus.Subscribe<arm_report_t>("ARM_REPORT_RIGHT", [this](const auto& m) {
      const bool is_seating = m.phase == "seat";
      if (is_seating && !was_seating_) ++num_seatings_;
      was_seating_ = is_seating;
      return true;
    });
    bus.Subscribe<arm_setpoint_t>("ARM_SETPOINT_RIGHT", [this](const auto& m) {
      if (num_seatings_ != kSeating || !was_seating_) return true;
      if (++num_setpoints_ < kFirst || num_setpoints_ > kLast) return true;
      arm_setpoint_t other = m;
      other.position[1] += 0.1;  // the shoulder, down
      other.deadline_utime = bus_.now() + 4 * kTickUs;
      bus_.Publish("ARM_SETPOINT_RIGHT", other);
      return true;
    });
  }

 private:
  static constexpr int kSeating = 2, kFirst = 300, kLast = 330;
  Bus& bus_;
  bool was_seating_ = false;
  int num_seatings_ = 0, num_setpoints_ = 0;
};

TEST(HoldAndResume, AProtectiveStopIsToldAndClearedByTheOperatorAlone) {
  AssemblingCell cell(kSeed, {{"saboteur", [](Bus& bus) {
                                 return std::make_unique<Saboteur>(bus);
                               }}});
  const SkillWatch skills(cell);
  std::optional<int32_t> stopped, resumed, cleared;
  int num_stops = 0;
  std::vector<operating_mode_t> held;
  cell.On<arm_state_t>(
      "ARM_STATE_RIGHT", [&, was = false](const arm_state_t& m) mutable {
        const bool is_stopped = m.servo == arm_state_t::STOPPED;
        if (is_stopped && !was) {
          ++num_stops;
          stopped = m.header.tick;
          resumed = *stopped + kHoldTicks;
          Command(cell, *resumed, command_mode_t::RESUME);
        }
        if (!is_stopped && was) cleared = m.header.tick;
        was = is_stopped;
      });
  cell.On<operating_mode_t>("MODE", [&](const auto& m) {
    if (m.mode == motion_permit_t::HOLD) held.push_back(m);
  });
  cell.Run();

  EXPECT_EQ(num_stops, 1);
  ASSERT_TRUE(cleared.has_value()) << "it never stopped, or stopped for good";
  EXPECT_GE(*cleared, *resumed);
  EXPECT_LE(*cleared, *resumed + 10);
  EXPECT_EQ(skills.NumOf(skill_result_t::STOPPED), 1);
  ASSERT_FALSE(held.empty());
  EXPECT_EQ(held[0].hold, motion_permit_t::AT_ONCE);
  EXPECT_THAT(held[0].reason, testing::HasSubstr("protective stop"));
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_THAT(cell.Score().missing, testing::IsEmpty());
}

}  // namespace
}  // namespace cell
