#include "common/bus/lcm_node.h"

#include <chrono>
#include <utility>

#include "cell/health_t.hpp"
#include "common/bus/bus_error.h"
#include "common/bus/decode.h"
#include "common/bus/lockstep_node.h"
#include "common/bus/process_usage.h"

namespace cell {
namespace {

using std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kHelloPeriod = 50ms;
constexpr auto kHealthInterval = 1s;
constexpr auto kLinger = 300ms;

// One service process in lockstep: LCM in, LCM out, and a look at the clock on
// the wall for HELLO, HEALTH and losses only.
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
                   }}) {
    main_.SubscribeTo(node_.WantedChannels(),
                      [this](const std::string& channel, Bytes bytes) {
                        OnMessage(channel, std::move(bytes));
                      });
  }

  void Run(const ProcessHooks& hooks, const std::atomic<bool>& stop) {
    hooks.on_ready();
    while (!stop && !node_.is_done()) {
      hooks.on_alive();
      const auto now = steady_clock::now();
      if (!node_.has_joined()) PublishHello(now);
      PublishHealth(now);
      WaitForAny({&main_}, 20);
      main_.Drain();
      bool has_advanced = false;
      while (node_.Advance()) has_advanced = true;
      if (has_advanced) last_advance_ = steady_clock::now();
      CheckLoss();
    }
    if (node_.is_done()) Linger();
  }

 private:
  // The last ACK may get lost: the clock would say its TICK again.
  void Linger() {
    const auto until = steady_clock::now() + kLinger;
    while (steady_clock::now() < until) {
      WaitForAny({&main_}, 20);
      main_.Drain();
    }
  }

  void OnMessage(const std::string& channel, Bytes bytes) {
    if (channel == kTickChannel) {
      if (const auto tick = Decode<tick_t>(bytes)) node_.PutTick(*tick);
    } else if (node_.Wants(channel)) {
      auto message = MessageFromWire(channel, std::move(bytes));
      if (message) node_.PutData(*message);
    }
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
  LcmPort main_;
  LcmPort control_;
  LockstepNode node_;
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
