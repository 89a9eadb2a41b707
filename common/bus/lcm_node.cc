#include "common/bus/lcm_node.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "cell/health_t.hpp"
#include "common/bus/bus_error.h"
#include "common/bus/clock.h"
#include "common/bus/decode.h"
#include "common/bus/lcm_receiver.h"
#include "common/bus/lockstep_node.h"
#include "common/bus/process_usage.h"

namespace cell {
namespace {

using std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kHelloPeriod = 50ms;
constexpr auto kHealthInterval = 1s;
constexpr auto kLinger = 300ms;

Channels Without(const std::string& channel, Channels channels) {
  if (channels) std::erase(*channels, channel);
  return channels;
}

// Gives priority to the services that the clock's own service waits for: one
// step of niceness decides which of the services that a TICK wakes runs first,
// and costs this one little otherwise. Without it a tick only takes longer.
void GiveWay() {
  [[maybe_unused]] const int niceness = nice(1);
}

// One service process in lockstep: LCM in, LCM out, and a look at the clock on
// the wall for HELLO, HEALTH and losses only. TICKs have a socket of their own,
// because they alone wake the process: what a TICK lists was sent before it,
// and waits in the other socket's buffer.
class LcmNode {
 public:
  LcmNode(const LcmAddress& address, const Roster& roster,
          const std::string& name, const ServiceFactory& factory)
      : name_(name),
        main_(address.MainUrl()),
        control_(address.ControlUrl()),
        node_(roster, name, RandomIdentity(), factory,
              {.send_data =
                   [this](const Message& message) {
                     main_.Publish(message.channel, *message.bytes);
                   },
               .send_ack =
                   [this](const ack_t& ack) {
                     control_.Publish(kAckChannel, Bus::Encode(ack));
                   }}),
        ticks_(
            address.group, address.port, Channels({kTickChannel}),
            [this](const std::string&, const Bytes& bytes) { OnTick(bytes); }),
        data_(address.group, address.port,
              Without(kTickChannel, node_.WantedChannels()),
              [this](const std::string& channel, Bytes bytes) {
                OnData(channel, std::move(bytes));
              }) {
    if (!FeedsClock(roster, roster.RequireIndexOf(name))) GiveWay();
  }

  void Run(const ProcessHooks& hooks, const std::atomic<bool>& stop) {
    hooks.on_ready();
    while (!stop && !node_.is_done()) {
      hooks.on_alive();
      const auto now = steady_clock::now();
      if (!node_.has_joined()) PublishHello(now);
      PublishHealth(now);
      Listen();
      bool has_advanced = false;
      while (node_.Advance()) has_advanced = true;
      if (has_advanced) last_advance_ = steady_clock::now();
      CheckLoss();
    }
    if (node_.is_done()) Linger();
  }

 private:
  using Receivers = std::vector<const LcmReceiver*>;

  // The last ACK may get lost: the clock would repeat its TICK.
  void Linger() {
    const auto until = steady_clock::now() + kLinger;
    while (steady_clock::now() < until) {
      Listen();
    }
  }

  void Listen() {
    // Between hosts, data may arrive after its TICK.
    const bool awaits_data = node_.MissingData().has_value();
    WaitForAny(awaits_data ? Receivers{&ticks_, &data_} : Receivers{&ticks_},
               20);
    ticks_.Drain();
    data_.Drain();
  }

  void OnTick(const Bytes& bytes) {
    if (auto tick = Decode<tick_t>(bytes)) node_.PutTick(*std::move(tick));
  }

  void OnData(const std::string& channel, Bytes bytes) {
    if (channel == kTickChannel || !node_.Wants(channel)) return;
    auto message = MessageFromWire(channel, std::move(bytes));
    if (message) node_.PutData(*message);
  }

  void PublishHello(steady_clock::time_point now) {
    if (now - last_hello_ < kHelloPeriod) return;
    last_hello_ = now;
    control_.Publish(kHelloChannel, Bus::Encode(node_.Hello()));
  }

  void PublishHealth(steady_clock::time_point now) {
    if (now - last_health_ < kHealthInterval) return;
    last_health_ = now;
    const ProcessUsage usage = UsageOfThisProcess();
    health_t health{};
    health.header.tick = node_.tick();
    health.header.sender = node_.sender();
    health.service = name_;
    health.cpu_us = usage.cpu_us;
    health.resident_bytes = usage.resident_bytes;
    health.num_repeats = node_.num_repeats();
    health.num_unknown_senders = node_.num_unknown_senders();
    control_.Publish(kHealthChannel, Bus::Encode(health));
  }

  void CheckLoss() {
    const auto missing = node_.MissingData();
    if (!missing) {
      last_advance_ = steady_clock::now();
    } else if (steady_clock::now() - last_advance_ > kLossTimeout) {
      throw BusError(*missing);
    }
  }

  std::string name_;
  LcmPort main_;  // both for sending only
  LcmPort control_;
  LockstepNode node_;
  LcmReceiver ticks_;
  LcmReceiver data_;
  steady_clock::time_point last_hello_{};
  steady_clock::time_point last_health_{};
  steady_clock::time_point last_advance_ = steady_clock::now();
};

}  // namespace

void RunLcmNode(const LcmAddress& address, const Roster& roster,
                const std::string& name, const ServiceFactory& factory,
                const ProcessHooks& hooks, const std::atomic<bool>& stop) {
  LcmNode(address, roster, name, factory).Run(hooks, stop);
}

}  // namespace cell
