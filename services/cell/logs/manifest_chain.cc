#include "services/cell/logs/manifest_chain.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/bus/manifest.h"

namespace cell::cli {
namespace {

using Candidates = std::map<int32_t, std::vector<ManifestLink>>;

// A TICK holds its number three times.
bool IsConsistent(const tick_t& tick) {
  return tick.header.tick >= 0 && tick.header.sender == 0 &&
         tick.header.seq == tick.header.tick &&
         tick.header.utime == int64_t{tick.header.tick} * kTickUs &&
         IsSound(tick.flows);
}

Candidates CandidatesIn(const LogIndex& index) {
  Candidates candidates;
  for (size_t i = 0; i < index.entries.size(); ++i) {
    const LogEntry& entry = index.entries[i];
    if (!entry.is_tick) continue;
    auto tick = Decode<tick_t>(entry.message);
    if (!tick || !IsConsistent(*tick)) continue;
    ManifestLink link;
    link.tick = *std::move(tick);
    link.message = TickMessage(link.tick);
    link.entry = i;
    candidates[link.tick.header.tick].push_back(std::move(link));
  }
  return candidates;
}

// The messages of the log by the TICK that should name them.
std::map<int32_t, std::vector<Message>> MessagesByTick(const LogIndex& index) {
  std::map<int32_t, std::vector<Message>> messages;
  for (const LogEntry& entry : index.entries) {
    const Message& m = entry.message;
    const bool is_named = !entry.is_short && !entry.is_tick &&
                          m.channel != kAckChannel &&
                          m.channel != kHelloChannel &&
                          m.channel != kHealthChannel && m.tick < INT32_MAX;
    if (is_named) messages[m.sender == 0 ? m.tick : m.tick + 1].push_back(m);
  }
  for (auto& [tick, of_tick] : messages) {
    std::sort(of_tick.begin(), of_tick.end(), OrderedBefore);
  }
  return messages;
}

// The TICK as it must have been if the log holds all that it named.
ManifestLink Guess(int32_t tick, int64_t previous_digest,
                   const std::vector<Message>& messages, const tick_t* seen,
                   bool is_last) {
  ManifestLink link;
  tick_t& guess = link.tick;
  guess.header.utime = int64_t{tick} * kTickUs;
  guess.header.tick = guess.header.seq = tick;
  guess.previous_digest = previous_digest;
  guess.is_last = is_last ? 1 : 0;
  guess.flows = FlowsOf(messages);
  guess.num_flows = static_cast<int32_t>(guess.flows.size());
  if (seen != nullptr) guess.joined = seen->joined;
  guess.num_joined = static_cast<int32_t>(guess.joined.size());
  link.message = TickMessage(guess);
  return link;
}

bool DifferInOneByte(const Bytes& a, const Bytes& b) {
  if (a.size() != b.size()) return false;
  size_t num = 0;
  for (size_t i = 0; i < a.size(); ++i) num += a[i] != b[i];
  return num == 1;
}

// From the last TICK to the first: each is judged by the one after it.
class ChainFinder {
 public:
  explicit ChainFinder(const LogIndex& index)
      : candidates_(CandidatesIn(index)), messages_(MessagesByTick(index)) {
    for (const auto& [tick, messages] : messages_) {
      for (const Message& message : messages) channels_.insert(message.channel);
    }
  }

  std::map<int32_t, ManifestLink> Find() {
    std::set<int32_t, std::greater<>> ticks;
    for (const auto& [tick, links] : candidates_) {
      ticks.insert(tick);
      if (tick > 0) ticks.insert(tick - 1);  // it may be rebuilt
    }
    for (const int32_t tick : ticks) {
      if (chain_.contains(tick)) continue;
      auto link = chain_.contains(tick + 1) ? ByTheNext(tick) : ByItself(tick);
      if (!link && RebuildUpTo(tick)) continue;
      if (link) chain_.emplace(tick, std::move(*link));
    }
    return std::move(chain_);
  }

 private:
  const ManifestLink* Seen(int32_t tick) const {
    const auto it = candidates_.find(tick);
    return it == candidates_.end() ? nullptr : &it->second.front();
  }

  std::optional<ManifestLink> GuessOf(int32_t tick) const {
    const ManifestLink* before = Seen(tick - 1);
    if (tick > 0 && before == nullptr) return std::nullopt;
    const ManifestLink* seen = Seen(tick);
    const bool is_last = seen != nullptr && seen->tick.is_last != 0 &&
                         tick == candidates_.rbegin()->first;
    return Guess(tick, before == nullptr ? 0 : before->message.digest,
                 NamedBy(tick), seen == nullptr ? nullptr : &seen->tick,
                 is_last);
  }

  std::vector<Message> NamedBy(int32_t tick) const {
    const auto named = messages_.find(tick);
    return named == messages_.end() ? std::vector<Message>{} : named->second;
  }

  // Guesses all that are lost from the last one that was seen up to `tick`, and
  // takes them if the one after it confirms the last.
  bool RebuildUpTo(int32_t tick) {
    const auto next = chain_.find(tick + 1);
    const auto after = candidates_.lower_bound(tick);
    if (next == chain_.end() || after == candidates_.begin()) return false;
    const auto& [seen_tick, offers] = *std::prev(after);
    // In a run there is something to name in almost every tick.
    if (static_cast<size_t>(tick - seen_tick) > 2 * messages_.size()) {
      return false;
    }
    for (const ManifestLink& offer : offers) {
      std::map<int32_t, ManifestLink> guesses;
      int64_t digest = offer.message.digest;
      for (int32_t k = seen_tick + 1; k <= tick; ++k) {
        ManifestLink guess = Guess(k, digest, NamedBy(k), nullptr, false);
        guess.is_proved = true;
        digest = guess.message.digest;
        guesses.emplace(k, std::move(guess));
      }
      if (digest != next->second.tick.previous_digest) continue;
      chain_.merge(guesses);
      return true;
    }
    return false;
  }

  std::optional<ManifestLink> ByTheNext(int32_t tick) const {
    const ManifestLink& next = chain_.at(tick + 1);
    const auto offers = candidates_.find(tick);
    if (offers != candidates_.end()) {
      for (ManifestLink link : offers->second) {
        link.is_proved = true;
        if (link.message.digest == next.tick.previous_digest) return link;
      }
    }
    auto guess = GuessOf(tick);
    if (guess && guess->message.digest == next.tick.previous_digest) {
      guess->is_proved = true;
      return guess;
    }
    return next.is_proved ? std::nullopt : ByItself(tick);
  }

  std::optional<ManifestLink> ByItself(int32_t tick) const {
    if (Seen(tick) == nullptr) return std::nullopt;
    ManifestLink seen = *Seen(tick);
    const auto guess = GuessOf(tick);
    if (!guess) return seen;
    seen.is_proved = seen.message.digest == guess->message.digest;
    const bool is_guess_right =
        DifferInOneByte(*seen.message.bytes, *guess->message.bytes) &&
        !NamesOtherChannel(seen.tick, guess->tick);
    return is_guess_right ? guess : seen;
  }

  // True if the one byte is that of a channel, and the message has the wrong
  // one: the TICK's channel occurs elsewhere.
  bool NamesOtherChannel(const tick_t& seen, const tick_t& guess) const {
    for (size_t i = 0; i < seen.flows.size() && i < guess.flows.size(); ++i) {
      const std::string& channel = seen.flows[i].channel;
      if (channel != guess.flows[i].channel) return channels_.contains(channel);
    }
    return false;
  }

  Candidates candidates_;
  std::map<int32_t, std::vector<Message>> messages_;
  std::set<std::string> channels_;  // that messages came on
  std::map<int32_t, ManifestLink> chain_;
};

}  // namespace

std::map<int32_t, ManifestLink> FindManifests(const LogIndex& index) {
  return ChainFinder(index).Find();
}

}  // namespace cell::cli
