#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/message.h"
#include "common/bus/roster.h"

namespace cell {

/// The Bus that a service sees, pure: decides order, depth, timers, latency,
/// stamps and counts. Its caller - LCM, SimBus, a log - only decides which
/// messages belong to which tick.
class Stepper final : public Bus {
 public:
  struct Params {
    std::string name;          ///< of the service, as in the roster
    std::string truth_role;    ///< as in truth_access.h; empty: the name
    int32_t sender = 0;        ///< given by the clock
    int32_t latency = 1;       ///< ticks one activation takes; 1: same tick
    int32_t status_phase = 0;  ///< tick % kStatusPeriod of its STATUS
    /// Ticks may be skipped (live): timers that fell due in them run in the
    /// next one.
    bool skips_ticks = false;
  };
  static constexpr int32_t kStatusPeriod = 62;

  explicit Stepper(Params params);

  void SubscribeBytes(const std::string& channel, size_t depth,
                      BytesHandler handler) override;
  void SubscribeAll(AnyHandler handler) override;
  void PublishBytes(const std::string& channel,
                    std::vector<uint8_t> bytes) override;
  void Every(int32_t period_ticks, int32_t phase,
             std::function<void()> timer) override;
  int64_t now() const override { return int64_t{tick_} * kTickUs; }
  int32_t tick() const override { return tick_; }
  void EndRunIn(int32_t ticks) override { end_tick_ = tick_ + ticks; }

  /// True if messages on `channel` are among the service's inputs.
  bool Wants(const std::string& channel) const;
  /// The channels it wants, and TICK.
  Channels WantedChannels() const;

  /// Takes the inputs of `tick` (only channels it wants; any order).
  enum class State {
    kWaiting,  ///< an earlier activation lasts; the inputs wait for its end
    kIdle,     ///< nothing to do in this tick
    kReady     ///< call Run() for this tick
  };
  State Accept(int32_t tick, std::vector<Message> inputs);

  /// Last tick of the activation that Run() is about to make: its outputs are
  /// stamped with it.
  int32_t until() const { return until_; }

  /// Runs the activation; the outputs in the order of publication, stamped.
  std::vector<Message> Run();

  /// The tick after which the service asks to end the run, if any.
  std::optional<int32_t> end_tick() const { return end_tick_; }
  const std::map<std::string, int64_t>& num_rejected() const {
    return num_rejected_;
  }
  const Params& params() const { return params_; }
  /// Before the first Accept(): the id that the clock gave this incarnation.
  void set_sender(int32_t sender) { params_.sender = sender; }

 private:
  struct Subscription {
    size_t depth;
    BytesHandler handler;
  };
  struct Timer {
    int32_t period;
    int32_t phase;
    std::function<void()> run;
  };

  Timer StatusTimer() const {
    return {kStatusPeriod, params_.status_phase, {}};
  }
  bool IsDue(const Timer& timer) const;
  void Deliver();
  void PublishStatus();

  Params params_;
  std::map<std::string, Subscription> subscriptions_;
  AnyHandler any_handler_;
  std::vector<Timer> timers_;

  std::vector<Message> inputs_;   // of the activation to come
  std::vector<Message> outputs_;  // of the activation that runs
  std::map<std::string, int32_t> next_seq_;
  std::map<std::string, int64_t> num_handled_;
  std::map<std::string, int64_t> num_rejected_;
  int32_t tick_ = 0;
  int32_t previous_tick_ = -1;  // of the activation before
  int32_t until_ = -1;
  bool is_running_ = false;
  bool has_begun_ = false;  // an Accept() was made
  std::optional<int32_t> end_tick_;
};

/// For an incarnation of the roster's service at `index`.
inline Stepper::Params StepperParams(const Roster& roster, size_t index,
                                     int32_t sender) {
  const Roster::Entry& entry = roster.entries[index];
  return {.name = entry.name,
          .truth_role = entry.truth_role,
          .sender = sender,
          .latency = entry.latency,
          .status_phase = static_cast<int32_t>(index) % Stepper::kStatusPeriod};
}

}  // namespace cell
