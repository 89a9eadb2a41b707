#include "common/bus/clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "cell/types_digest.h"
#include "common/bus/manifest.h"

namespace cell {

bool FeedsClock(const Roster& roster, size_t index) {
  return roster.entries[index].feeds_clock ||
         std::ranges::none_of(roster.entries, &Roster::Entry::feeds_clock);
}

Clock::Clock(Roster roster, int64_t run)
    : roster_(std::move(roster)), run_(run), slots_(roster_.entries.size()) {}

std::optional<std::string> Clock::Hello(const hello_t& hello) {
  const auto index = roster_.IndexOf(hello.name);
  if (!index) {
    return fmt::format("'{}' is not in the roster (roster.yaml)", hello.name);
  }
  if (*index == 0) {
    return fmt::format(
        "'{}' is the clock, and it is running; another cell on this port?",
        hello.name);
  }
  if (hello.types_digest != kTypesDigest) {
    return fmt::format(
        "'{}' was built with other message types ({:x}, the clock has {:x}); "
        "build all services from one tree",
        hello.name, hello.types_digest, kTypesDigest);
  }
  Slot& slot = slots_[*index];
  if (slot.incarnation >= 0 && slot.nonce == hello.nonce) return std::nullopt;
  slot.successor = hello.nonce;
  slot.is_dead = slot.incarnation >= 0;
  return std::nullopt;
}

bool Clock::Ack(const ack_t& ack) {
  const auto index = static_cast<size_t>(BaseOf(ack.header.sender));
  if (ack.run != run_ || ack.header.sender < 0 || index == 0 ||
      index >= slots_.size() || !IsSound(ack.flows)) {
    return false;
  }
  Slot& slot = slots_[index];
  const int32_t lead = roster_.entries[index].latency - 1;
  const bool is_new = ack.nonce == slot.nonce && slot.incarnation >= 0 &&
                      !slot.is_dead && ack.header.tick > slot.acted &&
                      ack.header.tick <= tick_;
  if (!is_new) return false;
  if (ack.is_busy) {
    if (ack.until != ack.header.tick + lead) return false;
    slot.answered = ack.until - 1;
    return true;
  }
  slot.answered = slot.acted = ack.header.tick;
  if (ack.num_flows > 0) slot.flows[ack.header.tick] = ack.flows;
  return true;
}

std::vector<std::string> Clock::MissingFromRoster() const {
  std::vector<std::string> names;
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (slots_[i].incarnation < 0 && !slots_[i].successor && tick_ < 0) {
      names.push_back(roster_.entries[i].name);
    }
  }
  return names;
}

bool Clock::IsAwaited(size_t index, Before what) const {
  const Slot& slot = slots_[index];
  return slot.incarnation >= 0 && !slot.is_dead && slot.answered < tick_ &&
         (what == Before::kTick || FeedsClock(roster_, index));
}

bool Clock::IsAwaiting(Before what) const {
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (IsAwaited(i, what)) return true;
  }
  return false;
}

std::vector<std::string> Clock::Awaited(Before what) const {
  std::vector<std::string> names;
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (IsAwaited(i, what)) names.push_back(roster_.entries[i].name);
  }
  return names;
}

std::optional<std::string> Clock::UndeclaredFeeder(
    const std::function<bool(const std::string& channel)>& wants) const {
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (FeedsClock(roster_, i)) continue;
    const auto it = slots_[i].flows.find(tick_);
    if (it == slots_[i].flows.end()) continue;
    for (const flow_t& flow : it->second) {
      if (!wants(flow.channel)) continue;
      return fmt::format(
          "{} publishes {}, which {} reads without waiting for it: give it "
          "feeds_clock: true in roster.yaml",
          roster_.entries[i].name, flow.channel, roster_.entries[0].name);
    }
  }
  return std::nullopt;
}

std::vector<flow_t> Clock::CurrentFlows() const {
  std::vector<flow_t> flows;
  for (const Slot& slot : slots_) {
    const auto it = slot.flows.find(tick_);
    if (it == slot.flows.end()) continue;
    flows.insert(flows.end(), it->second.begin(), it->second.end());
  }
  return flows;
}

std::vector<joined_t> Clock::JoinWaiting() {
  std::vector<joined_t> joined;
  for (size_t i = 1; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (!slot.successor) continue;
    joined_t& entry = joined.emplace_back();
    entry.name = roster_.entries[i].name;
    entry.nonce = *slot.successor;
    entry.death_tick = slot.incarnation >= 0 ? slot.acted + 1 : -1;
    const int32_t incarnation = slot.incarnation + 1;
    slot = Slot{};
    slot.incarnation = incarnation;
    slot.nonce = entry.nonce;
    slot.answered = slot.acted = tick_ - 1;
    entry.sender = SenderOf(i, incarnation);
  }
  return joined;
}

const tick_t& Clock::Advance(const std::vector<Message>& own, bool is_last) {
  if (!MissingFromRoster().empty() || IsAwaiting(Before::kTick)) {
    throw std::logic_error(
        fmt::format("TICK {} before all have answered {}", tick_ + 1, tick_));
  }
  tick_t tick{};
  tick.flows = CurrentFlows();
  const std::vector<flow_t> own_flows = FlowsOf(own);
  tick.flows.insert(tick.flows.end(), own_flows.begin(), own_flows.end());
  std::sort(
      tick.flows.begin(), tick.flows.end(), [](const auto& a, const auto& b) {
        return std::tie(a.channel, a.sender) < std::tie(b.channel, b.sender);
      });
  for (Slot& slot : slots_) slot.flows.erase(tick_);
  ++tick_;
  tick.header.utime = int64_t{tick_} * kTickUs;
  tick.header.tick = tick_;
  tick.header.seq = tick_;
  tick.run = run_;
  tick.previous_digest = previous_digest_;
  tick.is_last = is_last ? 1 : 0;
  tick.num_flows = static_cast<int32_t>(tick.flows.size());
  tick.joined = JoinWaiting();
  tick.num_joined = static_cast<int32_t>(tick.joined.size());
  previous_digest_ = TickMessage(tick).digest;

  ForgetTicks();
  return recent_.emplace_back(std::move(tick));
}

void Clock::ForgetTicks() {
  int32_t oldest = tick_;
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (slots_[i].incarnation < 0) continue;
    oldest = std::min(oldest, slots_[i].acted + 1);
  }
  std::erase_if(recent_, [oldest](const tick_t& old) {
    return old.header.tick < oldest;
  });
}

std::vector<tick_t> Clock::TicksToRepeat() const {
  return recent_;
}

}  // namespace cell
