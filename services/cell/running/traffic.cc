#include "services/cell/running/traffic.h"

#include <algorithm>
#include <utility>

#include "common/bus/decode.h"

namespace cell::cli {
namespace {

/// More channels or services than any cell has are forged.
constexpr size_t kMaxNames = 1000;

constexpr char kRejected[] = "rejected:";

int64_t SumOf(const health_t& health, const std::string& prefix) {
  int64_t sum = 0;
  for (const counter_t& counter : health.counters) {
    if (counter.name.starts_with(prefix)) sum += counter.value;
  }
  return sum;
}

}  // namespace

std::optional<Message> Traffic::OnMessage(const std::string& channel,
                                          Bytes bytes) {
  const auto message = MessageFromWire(channel, std::move(bytes));
  if (!message) {
    ++num_foreign_;
    return std::nullopt;
  }
  if (channel == kStatusChannel) {
    if (const auto status = Decode<status_t>(*message)) OnStatus(*status);
  }
  OnMessage(*message);
  return *message;
}

void Traffic::OnControl(const std::string& channel, Bytes bytes, double now_s) {
  const auto message = MessageFromWire(channel, std::move(bytes));
  const auto health = message ? Decode<health_t>(*message) : std::nullopt;
  health ? OnHealth(*health, now_s) : static_cast<void>(++num_foreign_);
}

void Traffic::OnMessage(const Message& message) {
  if (counts_.size() >= kMaxNames && !counts_.contains(message.channel)) {
    ++num_foreign_;
    return;
  }
  arrivals_.Accept(message);
  Count& count = counts_[message.channel];
  ++count.messages;
  count.bytes += static_cast<int64_t>(message.bytes->size());
}

void Traffic::OnHealth(const health_t& health, double now_s) {
  if (health_.size() >= kMaxNames && !health_.contains(health.service)) return;
  const auto [it, is_first] = health_.try_emplace(health.service);
  Health& known = it->second;
  // A new incarnation counts from 0.
  if (is_first || health.header.sender != known.last.header.sender) {
    known.cpu_us_before = health.cpu_us;
    known.before_s = now_s;
  }
  known.last = health;
  known.last_s = now_s;
}

void Traffic::OnStatus(const status_t& status) {
  if (rejected_.size() >= kMaxNames && !rejected_.contains(status.service)) {
    return;
  }
  std::map<std::string, int64_t>& by_channel = rejected_[status.service];
  by_channel.clear();
  for (const counter_t& counter : status.counters) {
    if (!counter.name.starts_with(kRejected)) continue;
    by_channel[counter.name.substr(sizeof(kRejected) - 1)] = counter.value;
  }
}

bool Traffic::KnowsProcessorTimes() const {
  if (health_.empty()) return counts_.empty();
  return std::ranges::all_of(health_, [](const auto& entry) {
    return entry.second.processor || entry.second.has_two();
  });
}

Traffic::Report Traffic::MakeReport(double seconds) {
  Report report;
  std::map<std::string, int64_t> rejected;
  for (const auto& [service, by_channel] : rejected_) {
    for (const auto& [channel, count] : by_channel) rejected[channel] += count;
  }
  for (const auto& [channel, count] : rejected) counts_[channel];
  for (auto& [name, count] : counts_) {
    Channel& channel = report.channels.emplace_back();
    channel.name = name;
    channel.rate_hz = static_cast<double>(count.messages) / seconds;
    channel.bytes_per_s = static_cast<double>(count.bytes) / seconds;
    const auto lost = arrivals_.num_lost().find(name);
    if (lost != arrivals_.num_lost().end()) channel.num_lost = lost->second;
    channel.num_rejected = rejected[name];
    count = {};
  }
  for (auto& [name, health] : health_) {
    const health_t& last = health.last;
    if (health.has_two()) {
      health.processor =
          1e-6 * static_cast<double>(last.cpu_us - health.cpu_us_before) /
          (health.last_s - health.before_s);
    }
    report.processes.push_back(
        {.name = name,
         .processor = health.processor,
         .resident_bytes = last.resident_bytes,
         .num_lost = SumOf(last, "lost:"),
         .num_late = SumOf(last, "late:"),
         .num_unknown_senders = last.num_unknown_senders});
    health.cpu_us_before = last.cpu_us;
    health.before_s = health.last_s;
  }
  report.num_foreign = num_foreign_ + arrivals_.num_unknown_senders();
  return report;
}

}  // namespace cell::cli
