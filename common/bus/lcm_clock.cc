#include "common/bus/lcm_clock.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <set>
#include <thread>
#include <utility>

#include "common/bus/bus_error.h"
#include "common/bus/clock.h"
#include "common/bus/decode.h"
#include "common/bus/inbox.h"
#include "common/bus/lcm_receiver.h"
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
        host_(roster, factory),
        clock_(roster, RandomIdentity()),
        data_(address.group, address.port, host_.WantedChannels(),
              [this](const std::string& channel, Bytes bytes) {
                OnData(channel, std::move(bytes));
              }),
        control_(address.group, address.port + 1, kAllChannels,
                 [this](const std::string& channel, Bytes bytes) {
                   OnControl(channel, std::move(bytes));
                 }) {}

  LcmClockSummary Run() {
    hooks_.on_ready();
    if (!AwaitRoster()) return summary_;
    const auto start = steady_clock::now();
    bool is_last = false;
    while (!is_last && AwaitAcks(Clock::Before::kActing)) {
      const int32_t tick = clock_.tick() + 1;
      if (options_.is_realtime) SleepUntil(start, tick);
      const auto inputs = AwaitInputs();
      if (!inputs) break;
      const std::vector<Message> own =
          host_.Tick(tick, *inputs, std::exchange(commands_, {}));
      if (!AwaitAcks(Clock::Before::kTick)) break;
      if (const auto error = clock_.UndeclaredFeeder(host_wants_)) {
        throw BusError("clock: " + *error);
      }
      // A stopped clock still publishes a last TICK, so that all services end.
      is_last = host_.IsLast(tick) || stop_;
      const tick_t& manifest = clock_.Advance(own, is_last);
      for (const Message& message : own) {
        main_.Publish(message.channel, *message.bytes);
      }
      main_.Publish(kTickChannel, Bus::Encode(manifest));
      inbox_.Purge(tick - 1);
    }
    AwaitAcks(Clock::Before::kTick);
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
    } else if (IsCommand(channel)) {
      OnCommand({channel, std::move(bytes)});
    }
  }

  void OnCommand(Command command) {
    if (commands_.size() < kMaxWaitingCommands) {
      commands_.push_back(std::move(command));
    } else {
      ++summary_.num_refused;
    }
  }

  // Data alone does not wake the clock: an ACK names it.
  void Listen() {
    hooks_.on_alive();
    WaitForAny({&control_}, 20);
    control_.Drain();
  }

  // Warns periodically; throws after giveup_s, if that is set.
  template <class Names>
  void Watch(steady_clock::time_point since, const char* what, Names names) {
    const auto now = steady_clock::now();
    if (options_.giveup_s &&
        now - since > std::chrono::duration<double>(*options_.giveup_s)) {
      throw BusError(fmt::format("clock: tick {}: gave up waiting for {} of {}",
                                 clock_.tick(), what,
                                 fmt::join(names(), ", ")));
    }
    if (now - std::max(since, last_warning_) > kWarnPeriod) {
      last_warning_ = now;
      std::cerr << fmt::format("clock: tick {}: waiting for {} of {}\n",
                               clock_.tick(), what, fmt::join(names(), ", "));
    }
  }

  bool AwaitRoster() {
    const auto since = steady_clock::now();
    while (!stop_) {
      const auto names = clock_.MissingFromRoster();
      if (names.empty()) return true;
      Watch(since, "HELLO", [&names] { return names; });
      Listen();
      data_.Drain();
    }
    return false;
  }

  // False if the clock was stopped before they came.
  bool AwaitAcks(Clock::Before what) {
    const auto since = steady_clock::now();
    auto last_repeat = since;
    while (!stop_ || steady_clock::now() - since < kStopGrace) {
      if (!clock_.IsAwaiting(what)) return true;
      Watch(since, "ACK", [&] { return clock_.Awaited(what); });
      Listen();
      if (steady_clock::now() - last_repeat < kRepeatPeriod) continue;
      last_repeat = steady_clock::now();
      data_.Drain();
      for (const tick_t& tick : clock_.TicksToRepeat()) {
        ++summary_.num_repeats;
        main_.Publish(kTickChannel, Bus::Encode(tick));
      }
    }
    return false;
  }

  // The messages of the tick before that the host wants; they were announced
  // by ACKs and may still be on their way.
  std::optional<std::vector<Message>> AwaitInputs() {
    const auto ids = MessagesIn(clock_.CurrentFlows(), host_wants_);
    const auto since = steady_clock::now();
    for (data_.Drain();; data_.Drain()) {
      if (auto messages = inbox_.Pop(ids)) return messages;
      if (stop_) return std::nullopt;
      if (steady_clock::now() - since > kLossTimeout) {
        throw BusError("LOST clock: needs channel " +
                       ToString(*inbox_.missing()) +
                       " (check recv_buf_size and net.core.rmem_max)");
      }
      hooks_.on_alive();
      WaitForAny({&data_}, 20);
    }
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
  LcmPort main_;  // for sending only
  ClockHost host_;
  std::function<bool(const std::string&)> host_wants_ =
      [this](const std::string& channel) {
        return host_.Wants(channel);
      };
  Clock clock_;
  Inbox inbox_;
  LcmReceiver data_;
  LcmReceiver control_;
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
