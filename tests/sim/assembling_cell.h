#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/sim_bus.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/scoring/assembly_score.h"
#include "services/cell/scoring/pose_history.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;

/// The shipped cell without its recorder, in one process, while it assembles by
/// itself: a test hears every message and may intervene.
class AssemblingCell {
 public:
  /// `guests`: services of the test itself, at the end of the roster.
  explicit AssemblingCell(
      uint64_t seed, const std::map<std::string, ServiceFactory>& guests = {},
      const Deployment& deployment = ShippedDeployment(),
      const std::string& script = "execution") {
    Roster roster = Roster::FromConfig(deployment.ForService("roster"));
    std::erase_if(roster.entries, [](const Roster::Entry& entry) {
      return entry.name == "recorder";
    });
    auto factories = AllServices(deployment, script, seed);
    for (const auto& [name, factory] : guests) {
      roster.entries.push_back({.name = name, .feeds_clock = true});
      factories[name] = factory;
    }
    bus_ = std::make_unique<SimBus>(roster, std::move(factories));
    On<truth_poses_t>("TRUTH_POSES", [this](const truth_poses_t& poses) {
      looks_.Put(poses);
    });
  }

  SimBus& bus() { return *bus_; }
  int32_t tick() const { return bus_->last_tick().header.tick; }
  double seconds() const { return 1e-6 * kTickUs * tick(); }

  /// Calls `handler` for every message on `channel`, in the order of their
  /// manifests. header.tick is the tick in which one was published.
  template <class M>
  void On(const std::string& channel, std::function<void(const M&)> handler) {
    handlers_.emplace(channel, [handler](const Message& message) {
      M decoded{};
      decoded.decode(message.bytes->data(), 0,
                     static_cast<int>(message.bytes->size()));
      handler(decoded);
    });
  }
  void OnMessage(std::function<void(const Message&)> handler) {
    message_handlers_.push_back(std::move(handler));
  }
  void OnTick(std::function<void()> handler) {
    tick_handlers_.push_back(std::move(handler));
  }

  /// To the end of the episode, or of a test that hangs.
  void Run(int32_t max_ticks = 45'000) {
    while (bus_->last_tick().header.tick < max_ticks && bus_->Step()) {
      for (const Message& message : bus_->last_messages()) {
        const auto [begin, end] = handlers_.equal_range(message.channel);
        for (auto it = begin; it != end; ++it) it->second(message);
        for (const auto& handler : message_handlers_) handler(message);
      }
      for (const auto& handler : tick_handlers_) handler();
    }
  }

  AssemblyScore Score() const {
    return ScoreAssembly(looks_.earlier(), looks_.last(),
                         SuccessCriterion::Load(ShippedDeployment()));
  }

 private:
  std::unique_ptr<SimBus> bus_;
  std::multimap<std::string, std::function<void(const Message&)>> handlers_;
  std::vector<std::function<void(const Message&)>> message_handlers_;
  std::vector<std::function<void()>> tick_handlers_;
  PoseHistory looks_;
};

}  // namespace cell
