// A person is watched while services that watch die: every placement is
// explained or reported.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/truth_action_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/sim_bus.h"
#include "services/cell/running/service_registry.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;

namespace {

using testing::HasSubstr;

/// The shipped cell without its recorder, while a person places two pegs.
class WatchedCell {
 public:
  explicit WatchedCell(std::vector<SimBus::Outage> outages = {}) {
    const Deployment deployment = ShippedDeployment();
    Roster roster = Roster::FromConfig(deployment.ForService("roster"));
    std::erase_if(roster.entries, [](const Roster::Entry& entry) {
      return entry.name == "recorder";
    });
    SimBus bus(roster, AllServices(deployment, "two_pegs", 1000),
               std::move(outages));
    while (bus.Step()) {
      for (const Message& message : bus.last_messages()) OnMessage(message);
    }
  }

  struct Placement {
    std::string part;
    int32_t tick;
  };
  const std::vector<Placement>& placements() const { return placements_; }
  /// Recognised actions, and changes reported as unexplained.
  const std::string& reported() const { return reported_; }
  int num_unseen() const { return num_unseen_; }

 private:
  void OnMessage(const Message& message) {
    if (message.channel == "TRUTH_ACTIONS") {
      const auto action = Decode<truth_action_t>(message);
      if (action->kind == truth_action_t::PLACED) {
        placements_.push_back({action->part, message.tick});
      }
    } else if (message.channel == "ACTION") {
      const auto action = Decode<recognised_action_t>(message);
      if (action->kind == recognised_action_t::FORWARD)
        reported_ += action->part + "\n";
    } else if (message.channel == "ALERT") {
      const auto alert = Decode<alert_t>(message);
      if (alert->cause != alert_t::UNSEEN) return;
      reported_ += alert->text + "\n";
      ++num_unseen_;
    }
  }

  std::vector<Placement> placements_;
  std::string reported_;
  int num_unseen_ = 0;
};

const WatchedCell& Undisturbed() {
  static const WatchedCell cell;
  return cell;
}

TEST(WatchedDeaths, WithoutOneEveryPlacementIsRecognised) {
  ASSERT_EQ(Undisturbed().placements().size(), 2u);
  for (const auto& placement : Undisturbed().placements()) {
    EXPECT_THAT(Undisturbed().reported(), HasSubstr(placement.part));
  }
  EXPECT_EQ(Undisturbed().num_unseen(), 0) << Undisturbed().reported();
}

// The recognizer misses a placement; then the planner dies, which had seen it.
TEST(WatchedDeaths, OfTheRecognizerAndThenThePlannerLeaveNothingUnreported) {
  const int32_t tick = Undisturbed().placements().front().tick;
  const WatchedCell cell({{"recognizer", tick - 60, tick + 40},
                          {"planner", tick + 60, tick + 90}});
  for (const auto& placement : Undisturbed().placements()) {
    EXPECT_THAT(cell.reported(), HasSubstr(placement.part));
  }
}

}  // namespace
}  // namespace cell
