#include "common/bus/lcm_follow.h"

#include <chrono>
#include <utility>

#include "common/bus/bus_error.h"
#include "common/bus/decode.h"
#include "common/bus/follow_node.h"

namespace cell {

using std::chrono::steady_clock;

FollowSummary RunLcmFollow(const LcmAddress& address, const Roster& roster,
                           const std::string& name,
                           const ServiceFactory& factory,
                           const ProcessHooks& hooks,
                           const std::atomic<bool>& stop) {
  LcmPort port(address.MainUrl());
  FollowNode node(roster, name, factory, [&port](const Message& message) {
    port.Publish(message.channel, *message.bytes);
  });
  port.SubscribeTo(
      node.WantedChannels(), [&node](const std::string& channel, Bytes bytes) {
        if (channel == kTickChannel) {
          const auto tick = Decode<tick_t>(bytes);
          if (tick) node.PutTick(*tick);
        } else if (const auto message =
                       MessageFromWire(channel, std::move(bytes))) {
          node.PutData(*message);
        }
      });
  hooks.on_ready();
  auto last_advance = steady_clock::now();
  while (!stop && !node.is_done()) {
    hooks.on_alive();
    WaitForAny({&port}, 20);
    port.Drain();
    bool has_advanced = false;
    while (node.Advance()) has_advanced = true;
    const auto missing = node.MissingData();
    if (has_advanced || !missing) {
      last_advance = steady_clock::now();
    } else if (steady_clock::now() - last_advance > kLossTimeout) {
      throw BusError(*missing);
    }
  }
  return {node.tick() + 1, node.num_equal(), node.difference()};
}

}  // namespace cell
