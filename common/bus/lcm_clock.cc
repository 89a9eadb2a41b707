#include "common/bus/lcm_clock.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <iostream>
#include <set>
#include <thread>
#include <utility>

#include "common/bus/bus_error.h"
#include "common/bus/clock.h"
#include "common/bus/decode.h"
#include "common/bus/inbox.h"
#include "common/bus/manifest.h"
#include "common/text/printable.h"

namespace cell {
namespace {

using std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kRepeatPeriod = 200ms;
constexpr auto kWarnPeriod = 5s;
constexpr auto kStopGrace = 2s;
constexpr size_t kMaxWaitingCommands = 100;
constexpr size_t kMaxComplaints = 100;

class LcmClock {
 public:
  LcmClock(const LcmAddress& address, const Roster& roster,
           const ServiceFactory& factory, const LcmClockOptions& options,
           const ProcessHooks& hooks, const std::atomic<bool>& stop)
      : options_(options),
        hooks_(hooks),
        stop_(stop),
        main_(address.MainUrl()),
        control_(address.ControlUrl()),
        host_(roster, factory),
        clock_(roster, RandomIdentity()) {
    main_.SubscribeTo(host_.WantedChannels(),
                      [this](const std::string& channel, Bytes bytes) {
                        OnData(channel, std::move(bytes));
                      });
    control_.Subscribe("(HELLO|ACK|COMMAND_.*)",
                       [this](const std::string& channel, Bytes bytes) {
                         OnControl(channel, std::move(bytes));
                       });
  }

  LcmClockSummary Run() {
    hooks_.on_ready();
    if (!AwaitRoster()) return summary_;
    const auto start = steady_clock::now();
    bool is_last = false;
    while (!is_last && clock_.Awaited().empty()) {
      const int32_t tick = clock_.tick() + 1;
      if (options_.is_realtime) SleepUntil(start, tick);
      const auto inputs = AwaitInputs();
      if (!inputs) break;
      const std::vector<Message> own =
          host_.Tick(tick, *inputs, std::exchange(commands_, {}));
      // Whoever stops the clock still gets a last TICK out, so that all end.
      is_last = host_.IsLast(tick) || stop_;
      const tick_t& manifest = clock_.Advance(own, is_last);
      for (const Message& message : own) {
        main_.Publish(message.channel, *message.bytes);
      }
      main_.Publish(kTickChannel, Bus::Encode(manifest));
      inbox_.Purge(tick - 1);
      AwaitAcks();
    }
    summary_.num_ticks = clock_.tick() + 1;
    summary_.elapsed_s =
        std::chrono::duration<double>(steady_clock::now() - start).count();
    summary_.num_refused += host_.num_refused();
    return summary_;
  }

 private:
  void OnData(const std::string& channel, Bytes bytes) {
    if (channel == kTickChannel) {
      const auto tick = Decode<tick_t>(bytes);
      if (tick && tick->run != clock_.run()) {
        throw BusError(fmt::format(
            "another cell's clock is on this port (its TICK {}); give each "
            "cell its own port (--url)",
            tick->header.tick));
      }
    } else if (host_.Wants(channel) && !IsCommand(channel)) {
      auto message = MessageFromWire(channel, std::move(bytes));
      if (message) inbox_.Put(*message);
    }
  }

  void OnControl(const std::string& channel, Bytes bytes) {
    if (channel == kHelloChannel) {
      const auto hello = Decode<hello_t>(bytes);
      if (!hello) {
        ++summary_.num_refused;
      } else if (const auto refusal = clock_.Hello(*hello)) {
        ++summary_.num_refused;
        if (complaints_.size() < kMaxComplaints &&
            complaints_.insert(*refusal).second) {
          std::cerr << "clock: refuses " << Printable(*refusal) << std::endl;
        }
      }
    } else if (channel == kAckChannel) {
      const auto ack = Decode<ack_t>(bytes);
      if (!ack || !clock_.Ack(*ack)) ++summary_.num_refused;
    } else if (commands_.size() < kMaxWaitingCommands) {
      commands_.push_back({channel, std::move(bytes)});
    } else {
      ++summary_.num_refused;
    }
  }

  void Listen() {
    hooks_.on_alive();
    WaitForAny({&main_, &control_}, 20);
    control_.Drain();
    main_.Drain();
  }

  // Warns now and then, and gives up if that is wished.
  void Watch(steady_clock::time_point since,
             const std::vector<std::string>& names, const char* what) {
    const auto waited = steady_clock::now() - since;
    if (options_.giveup_s &&
        waited > std::chrono::duration<double>(*options_.giveup_s)) {
      throw BusError(fmt::format("clock: tick {}: gave up waiting for {} of {}",
                                 clock_.tick(), what, fmt::join(names, ", ")));
    }
    if (waited > kWarnPeriod &&
        steady_clock::now() - last_warning_ > kWarnPeriod) {
      last_warning_ = steady_clock::now();
      std::cerr << fmt::format("clock: tick {}: waiting for {} of {}\n",
                               clock_.tick(), what, fmt::join(names, ", "));
    }
  }

  bool AwaitRoster() {
    const auto since = steady_clock::now();
    while (!stop_) {
      const auto names = clock_.MissingFromRoster();
      if (names.empty()) return true;
      Watch(since, names, "HELLO");
      Listen();
    }
    return false;
  }

  void AwaitAcks() {
    const auto since = steady_clock::now();
    auto last_repeat = since;
    while (!stop_ || steady_clock::now() - since < kStopGrace) {
      const auto names = clock_.Awaited();
      if (names.empty()) return;
      Watch(since, names, "ACK");
      Listen();
      if (steady_clock::now() - last_repeat < kRepeatPeriod) continue;
      last_repeat = steady_clock::now();
      for (const tick_t& tick : clock_.TicksToRepeat()) {
        ++summary_.num_repeats;
        main_.Publish(kTickChannel, Bus::Encode(tick));
      }
    }
  }

  // The messages of the tick before that the host wants; they were announced
  // by ACKs and may still be on their way.
  std::optional<std::vector<Message>> AwaitInputs() {
    std::vector<MessageId> ids = MessagesIn(clock_.CurrentFlows());
    std::erase_if(
        ids, [this](const MessageId& id) { return !host_.Wants(id.channel); });
    const auto since = steady_clock::now();
    while (!stop_) {
      if (auto messages = inbox_.Take(ids)) return messages;
      if (steady_clock::now() - since > kLossTimeout) {
        throw BusError("LOST clock: needs channel " +
                       ToString(*inbox_.missing()) +
                       " (check recv_buf_size and net.core.rmem_max)");
      }
      Listen();
    }
    return std::nullopt;
  }

  void SleepUntil(steady_clock::time_point start, int32_t tick) {
    const auto due = start + std::chrono::microseconds(tick * kTickUs);
    if (steady_clock::now() > due + std::chrono::microseconds(kTickUs)) {
      ++summary_.num_late_ticks;
    }
    std::this_thread::sleep_until(due);
  }

  LcmClockOptions options_;
  ProcessHooks hooks_;
  const std::atomic<bool>& stop_;
  LcmPort main_;
  LcmPort control_;
  ClockHost host_;
  Clock clock_;
  Inbox inbox_;
  std::vector<Command> commands_;
  std::set<std::string> complaints_;
  LcmClockSummary summary_;
  steady_clock::time_point last_warning_{};
};

}  // namespace

LcmClockSummary RunLcmClock(const LcmAddress& address, const Roster& roster,
                            const ServiceFactory& factory,
                            const LcmClockOptions& options,
                            const ProcessHooks& hooks,
                            const std::atomic<bool>& stop) {
  return LcmClock(address, roster, factory, options, hooks, stop).Run();
}

}  // namespace cell
