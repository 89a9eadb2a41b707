// Services die while the cell assembles by itself: it stops where it must,
// goes on by itself, does nothing twice, and completes.
#include <gmock/gmock.h>

#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "tests/sim/assembling_cell.h"
#include "tests/sim/motion_watch.h"
#include "tests/sim/skill_watch.h"

namespace cell {
namespace {

constexpr uint64_t kSeed = 3;
constexpr int32_t kShort = 13, kMiddle = 125, kLong = 375;  // 0.1, 1, 3 s
constexpr int32_t kCalm = 250;     // ticks from an outage to the next
constexpr int32_t kAlertIn = 188;  // ticks: 1.5 s

struct DeathPoint {
  std::string phase;  // of the arm's skill
  int32_t delay;      // [ticks] from its beginning
};
const DeathPoint kPick{"reach", 25}, kCarry{"carry", 60}, kInsert{"seat", 90};

struct Death {
  std::string arm;  // whose skill it interrupts
  DeathPoint point;
  int32_t duration;  // [ticks]
};

/// Lets a service die again and again, each time with another part.
class Reaper {
 public:
  Reaper(AssemblingCell& cell, std::string service, std::vector<Death> deaths)
      : cell_(cell), service_(std::move(service)), planned_(std::move(deaths)) {
    for (const char* arm : {"LEFT", "RIGHT"}) {
      cell.On<arm_report_t>(std::string("ARM_REPORT_") + arm,
                            [this](const auto& m) { OnReport(m); });
    }
    cell.On<asked_skill_t>("SKILL_REQUEST", [this](const auto& m) {
      parts_[m.id] = ArgumentOf(m, "part");
    });
    cell.On<alert_t>("ALERT", [this](const auto& m) { OnAlert(m); });
  }

  size_t num_to_come() const { return planned_.size(); }
  const std::vector<SimBus::Outage>& outages() const { return outages_; }

  /// A lasting death is reported in time, a short one is not.
  void ExpectAlerts() const {
    for (const SimBus::Outage& outage : outages_) {
      const int32_t duration = outage.join_tick - outage.death_tick;
      int32_t told = -1;
      for (const int32_t tick : alerts_) {
        if (tick >= outage.death_tick && tick <= outage.join_tick + 1) {
          told = tick - outage.death_tick;
        }
      }
      if (service_ == "supervisor" || duration == kShort) {
        EXPECT_EQ(told, -1);
      } else if (duration == kLong) {
        EXPECT_GE(told, 0) << "nobody says that " << service_ << " is dead";
        EXPECT_LE(told, kAlertIn);
      }
    }
  }

 private:
  void OnReport(const arm_report_t& report) {
    std::string& phase = phases_[report.arm];
    if (phase == report.phase) return;
    phase = report.phase;
    const int32_t tick = cell_.tick();
    const std::string part = parts_[report.request];
    if (!outages_.empty() && tick < outages_.back().join_tick + kCalm) return;
    if (planned_.empty()) return;
    const Death next = planned_.front();
    if (next.arm != report.arm || next.point.phase != phase) return;
    if (tried_.contains(part)) return;
    const int32_t death = tick + next.point.delay;
    outages_.push_back({service_, death, death + next.duration});
    cell_.bus().Schedule(outages_.back());
    tried_.insert(part);
    planned_.erase(planned_.begin());
  }

  void OnAlert(const alert_t& alert) {
    if (std::getenv("CELL_VERBOSE")) {
      std::cerr << cell_.tick() << ": ALERT " << alert.text << "\n";
    }
    if (alert.cause != alert_t::SERVICE_SILENT ||
        alert.level == alert_t::INFO || !alert.text.starts_with(service_)) {
      return;
    }
    alerts_.push_back(alert.header.tick);
  }

  AssemblingCell& cell_;
  std::string service_;
  std::vector<Death> planned_;
  std::vector<SimBus::Outage> outages_;
  std::vector<int32_t> alerts_;
  std::map<std::string, std::string> phases_;  // by arm
  std::map<int64_t, std::string> parts_;       // by request
  std::set<std::string> tried_;                // parts
};

/// Runs an assembly with these deaths, each with another part, in this order.
void ExpectToComplete(uint64_t seed, const std::string& service,
                      const std::vector<Death>& deaths) {
  AssemblingCell cell(seed);
  const MotionWatch motion(cell);
  const SkillWatch skills(cell);
  const Reaper reaper(cell, service, deaths);
  cell.Run();

  std::cout << service << ": " << reaper.outages().size() << " deaths, "
            << motion.num_stops() << " stops, frozen after "
            << motion.max_freeze_ticks() << " ticks, at rest after "
            << motion.max_rest_ticks() << ", " << skills.results().size()
            << " skills, " << skills.NumOf(skill_result_t::FAILED)
            << " failed, " << cell.seconds() << " s\n";
  EXPECT_EQ(reaper.num_to_come(), 0u);
  reaper.ExpectAlerts();
  EXPECT_TRUE(skills.is_done()) << skills.question();
  EXPECT_THAT(cell.Score().missing, testing::IsEmpty());
  // A running skill is finished, unless the service of its own arm dies.
  for (const skill_result_t& result : skills.results()) {
    if (service == "robot_arm@" + result.arm) continue;
    EXPECT_EQ(result.outcome, skill_result_t::SUCCEEDED)
        << result.id << ": " << result.reason;
  }
}

class DeathsOf : public testing::TestWithParam<const char*> {};

TEST_P(DeathsOf, LeaveNothingUndoneAndDoNothingTwice) {
  std::vector<Death> deaths;
  for (const int32_t duration : {kShort, kMiddle, kLong}) {
    for (const DeathPoint& point : {kPick, kCarry, kInsert}) {
      deaths.push_back({"right", point, duration});
    }
  }
  ExpectToComplete(kSeed, GetParam(), deaths);
}

TEST(Deaths, OfAnArmInOtherPhasesAreRecoveredFrom) {
  ExpectToComplete(kSeed, "robot_arm@right",
                   {{"right", {"close", 12}, kShort},
                    {"right", {"lift", 25}, kMiddle},
                    {"right", {"let go", 6}, kShort},
                    {"right", {"draw back", 60}, kMiddle},
                    {"right", {"tare", 10}, kMiddle},
                    {"right", {"let go", 12}, kMiddle},
                    {"right", {"go to pendulum", 60}, kLong},
                    {"right", {"seat", 150}, kShort}});
}

INSTANTIATE_TEST_SUITE_P(EveryService, DeathsOf,
                         testing::Values("tracker", "sec_builder", "recognizer",
                                         "predicate_estimator", "planner",
                                         "robot_arm@left", "robot_arm@right",
                                         "motion_planner", "supervisor"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '@', '_');
                           return name;
                         });

}  // namespace
}  // namespace cell
