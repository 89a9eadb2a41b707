#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cell/ack_t.hpp"
#include "cell/hello_t.hpp"
#include "cell/tick_t.hpp"
#include "common/bus/message.h"
#include "common/bus/roster.h"

namespace cell {

/// True if the clock's own service waits for this one before it acts.
bool FeedsClock(const Roster& roster, size_t index);

/// The lockstep protocol as the clock sees it: which services have joined and
/// answered, what goes into the next TICK. Pure. Death is never inferred from
/// silence: only a HELLO of the same name with another nonce proves it.
class Clock {
 public:
  /// `run` distinguishes this start of the clock from others on the same port.
  Clock(Roster roster, int64_t run);

  /// Why the service cannot join, or nothing: it will with the next TICK.
  std::optional<std::string> Hello(const hello_t& hello);

  /// The service at this index of the roster is known to be dead: the clock
  /// does not wait for it until its successor joins.
  void MarkDead(size_t index) { slots_[index].is_dead = true; }

  /// False if the ACK is of another run, incarnation or tick and was ignored.
  bool Ack(const ack_t& ack);

  /// The services that still have to say HELLO before tick 0.
  std::vector<std::string> MissingFromRoster() const;

  /// The services that have not yet sent their ACK of this tick: before the
  /// clock's own service may act in the next one, or before the next TICK may
  /// go out.
  enum class Before { kActing, kTick };
  bool IsAwaiting(Before what) const;
  std::vector<std::string> Awaited(Before what = Before::kTick) const;

  /// What the services published in the current tick.
  std::vector<flow_t> CurrentFlows() const;

  /// Names a service that has published, in the current tick, a message that
  /// the clock's own service reads, although the roster has no feeds_clock for
  /// it.
  std::optional<std::string> UndeclaredFeeder(
      const std::function<bool(const std::string& channel)>& wants) const;

  /// Makes the next TICK; `own` are the clock's messages, stamped with it.
  /// @pre MissingFromRoster() and Awaited() are empty.
  const tick_t& Advance(const std::vector<Message>& own, bool is_last);

  /// TICKs that a silent service may have missed, oldest first.
  std::vector<tick_t> TicksToRepeat() const;

  /// Of the last TICK; -1 before the first.
  int32_t tick() const { return tick_; }
  int64_t run() const { return run_; }

 private:
  struct Slot {
    int32_t incarnation = -1;  // of the service that has joined; -1: none yet
    int64_t nonce = 0;
    bool is_dead = false;              // its successor has sent HELLO
    int32_t answered = -1;             // last tick the ACKs cover
    int32_t acted = -1;                // last tick with complete outputs
    std::optional<int64_t> successor;  // nonce of a HELLO yet to be joined
    std::map<int32_t, std::vector<flow_t>> flows;  // by tick
  };

  bool IsAwaited(size_t index, Before what) const;
  void ForgetTicks();
  std::vector<joined_t> JoinWaiting();

  Roster roster_;
  int64_t run_;
  int32_t tick_ = -1;
  int64_t previous_digest_ = 0;
  std::vector<Slot> slots_;  // by roster index; the clock's own is unused
  std::vector<tick_t> recent_;
};

}  // namespace cell
