#include "common/bus/lcm_live.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "cell/health_t.hpp"
#include "common/bus/bus_error.h"
#include "common/bus/live_node.h"
#include "common/bus/live_state.h"
#include "common/bus/process_usage.h"

namespace cell {
namespace {

using std::chrono::microseconds;
using std::chrono::steady_clock;

/// The roster's head acts at a tick's beginning, the others in its middle, so
/// that what it publishes reaches them in the same tick.
constexpr int64_t kPhaseUs = kTickUs / 2;
constexpr int32_t kMaxBehind = 125;
constexpr int32_t kHealthPeriod = 125;
constexpr int32_t kMaxTick = 1 << 30;

class LcmLive {
 public:
  LcmLive(const LcmAddress& address, const Roster& roster,
          const std::string& name, const ServiceFactory& factory,
          const std::filesystem::path& state_dir, const ProcessHooks& hooks)
      : hooks_(hooks),
        name_(name),
        is_head_(roster.RequireIndexOf(name) == 0),
        state_(state_dir),
        main_(address.MainUrl()),
        control_(address.ControlUrl()),
        node_(roster, name, state_.NextIncarnation(name), factory,
              [this](const Message& message) {
                main_.Publish(message.channel, *message.bytes);
              }) {
    main_.SubscribeTo(node_.WantedChannels(),
                      [this](const std::string& channel, Bytes bytes) {
                        OnMessage(channel, std::move(bytes));
                      });
    if (!is_head_) return;
    control_.Subscribe("COMMAND_.*",
                       [this](const std::string& channel, Bytes bytes) {
                         node_.Put(Command{channel, std::move(bytes)});
                       });
  }

  void Run(const std::atomic<bool>& stop) {
    const auto now = steady_clock::now().time_since_epoch();
    start_ = steady_clock::time_point(microseconds(
        state_.Epoch(std::chrono::duration_cast<microseconds>(now).count())));
    int32_t tick = TickNow() + 1;
    hooks_.on_ready();
    while (!stop) {
      std::this_thread::sleep_until(DueTime(tick));
      hooks_.on_alive();
      if (is_head_) control_.Drain();
      main_.Drain();
      tick = SkipTo(TickNow(), tick);
      node_.Step(tick);
      if (tick / kHealthPeriod != last_health_ / kHealthPeriod)
        PublishHealth(tick);
      ++tick;
    }
  }

 private:
  steady_clock::time_point DueTime(int32_t tick) const {
    return start_ + microseconds(tick * kTickUs + (is_head_ ? 0 : kPhaseUs));
  }

  int32_t TickNow() const {
    const auto since = std::chrono::duration_cast<microseconds>(
        steady_clock::now() - DueTime(0));
    const int64_t tick = since.count() / kTickUs;
    if (tick > kMaxTick) {
      throw BusError(
          "the cell has run for 99 days, the most that ticks can count; run "
          "cell down, then cell up");
    }
    return static_cast<int32_t>(tick);
  }

  int32_t SkipTo(int32_t now, int32_t tick) {
    const int32_t behind = now - tick;
    if (behind <= 0) return tick;
    ++num_late_steps_;
    return is_head_ && behind <= kMaxBehind ? tick : now;
  }

  void OnMessage(const std::string& channel, Bytes bytes) {
    auto message = MessageFromWire(channel, std::move(bytes));
    message ? node_.Put(*message) : void(++num_short_);
  }

  void PublishHealth(int32_t tick) {
    last_health_ = tick;
    const ProcessUsage usage = UsageOfThisProcess();
    health_t health{};
    health.header.tick = tick;
    health.header.sender = node_.sender();
    health.service = name_;
    health.cpu_us = usage.cpu_us;
    health.resident_bytes = usage.resident_bytes;
    health.num_repeats = node_.arrivals().num_repeated();
    health.num_unknown_senders =
        node_.arrivals().num_unknown_senders() + num_short_;
    const auto add = [&](const std::string& counter, int64_t value) {
      health.counters.push_back({counter, value});
    };
    for (const auto& [channel, count] : node_.num_late()) {
      add("late:" + channel, count);
    }
    add("late_steps", num_late_steps_);
    for (const auto& [channel, count] : node_.arrivals().num_lost()) {
      add("lost:" + channel, count);
    }
    health.num_counters = static_cast<int32_t>(health.counters.size());
    control_.Publish(kHealthChannel, Bus::Encode(health));
  }

  ProcessHooks hooks_;
  std::string name_;
  bool is_head_;
  LiveState state_;
  LcmPort main_;
  LcmPort control_;
  LiveNode node_;
  steady_clock::time_point start_;
  int32_t last_health_ = 0;
  int64_t num_late_steps_ = 0;
  int64_t num_short_ = 0;
};

}  // namespace

void RunLcmLive(const LcmAddress& address, const Roster& roster,
                const std::string& name, const ServiceFactory& factory,
                const std::filesystem::path& state_dir,
                const ProcessHooks& hooks, const std::atomic<bool>& stop) {
  LcmLive(address, roster, name, factory, state_dir, hooks).Run(stop);
}

}  // namespace cell
