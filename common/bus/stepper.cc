#include "common/bus/stepper.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cell/status_t.hpp"
#include "common/bus/truth_access.h"

namespace cell {

Stepper::Stepper(Params params) : params_(std::move(params)) {
  if (params_.truth_role.empty()) params_.truth_role = params_.name;
  if (params_.latency < 1) {
    throw std::logic_error(fmt::format("{}: latency {} ticks is less than 1",
                                       params_.name, params_.latency));
  }
}

void Stepper::SubscribeBytes(const std::string& channel, size_t depth,
                             BytesHandler handler) {
  if (IsTruth(channel) && !MayReadTruth(params_.name, params_.truth_role)) {
    throw std::logic_error(params_.name + " may not read " + channel +
                           ": ground truth (common/bus/truth_access.cc)");
  }
  const auto [it, is_new] =
      subscriptions_.try_emplace(channel, depth, std::move(handler));
  if (!is_new) {
    throw std::logic_error(params_.name + " subscribes twice to " + channel);
  }
}

void Stepper::SubscribeAll(AnyHandler handler) {
  if (!MayReadTruth(params_.name, params_.truth_role)) {
    throw std::logic_error(params_.name +
                           " may not read every channel: ground truth is "
                           "among them (common/bus/truth_access.cc)");
  }
  any_handler_ = std::move(handler);
}

void Stepper::PublishBytes(const std::string& channel,
                           std::vector<uint8_t> bytes) {
  if (!is_running_) {
    throw std::logic_error(params_.name + " publishes on " + channel +
                           " outside a handler or timer");
  }
  if (bytes.size() < kWireHeaderEnd) {
    throw std::logic_error(params_.name + " publishes " +
                           std::to_string(bytes.size()) + " bytes on " +
                           channel + ": no header");
  }
  const int32_t seq = next_seq_[channel]++;
  WriteIdentity(until_, params_.sender, seq, bytes);
  const int64_t digest = DigestOf(bytes);
  outputs_.push_back({channel, until_, params_.sender, seq, digest,
                      std::make_shared<const Bytes>(std::move(bytes))});
}

void Stepper::Every(int32_t period_ticks, int32_t phase,
                    std::function<void()> timer) {
  if (period_ticks < 1 || phase < 0 || phase >= period_ticks) {
    throw std::logic_error(fmt::format("{}: no timer with period {}, phase {}",
                                       params_.name, period_ticks, phase));
  }
  timers_.push_back({period_ticks, phase, std::move(timer)});
}

bool Stepper::Wants(const std::string& channel) const {
  return any_handler_ || subscriptions_.contains(channel);
}

Channels Stepper::WantedChannels() const {
  if (any_handler_) return kAllChannels;
  Channels channels({kTickChannel});
  for (const auto& entry : subscriptions_) channels->push_back(entry.first);
  return channels;
}

Stepper::State Stepper::Accept(int32_t tick, std::vector<Message> inputs) {
  inputs_.insert(inputs_.end(), std::make_move_iterator(inputs.begin()),
                 std::make_move_iterator(inputs.end()));
  if (tick <= until_) return State::kWaiting;
  tick_ = tick;
  if (!has_begun_ && params_.skips_ticks) previous_tick_ = tick - 1;
  has_begun_ = true;
  const bool has_timer =
      params_.latency == 1 &&
      (IsDue(StatusTimer()) ||
       std::any_of(timers_.begin(), timers_.end(),
                   [this](const Timer& timer) { return IsDue(timer); }));
  if (inputs_.empty() && !has_timer) return State::kIdle;
  until_ = tick + params_.latency - 1;
  return State::kReady;
}

std::vector<Message> Stepper::Run() {
  outputs_.clear();
  is_running_ = true;
  Deliver();
  for (const Timer& timer : timers_) {
    if (IsDue(timer)) timer.run();
  }
  if (IsDue(StatusTimer())) PublishStatus();
  is_running_ = false;
  previous_tick_ = tick_;
  return std::exchange(outputs_, {});
}

// A slow service, and one that skips ticks, takes the timers that fell due
// since its last activation along with its next one.
bool Stepper::IsDue(const Timer& timer) const {
  const bool is_late = params_.latency > 1 || params_.skips_ticks;
  const int32_t from = is_late ? std::max(previous_tick_ + 1, 0) : tick_;
  const int32_t since =
      ((tick_ - timer.phase) % timer.period + timer.period) % timer.period;
  return tick_ - since >= from;
}

void Stepper::Deliver() {
  std::sort(inputs_.begin(), inputs_.end(), OrderedBefore);
  std::map<std::string, size_t> num_left;
  for (const Message& message : inputs_) ++num_left[message.channel];
  for (const Message& message : std::exchange(inputs_, {})) {
    const size_t left = num_left[message.channel]--;
    if (any_handler_) {
      any_handler_(message.channel, *message.bytes);
      continue;
    }
    const Subscription& subscription = subscriptions_.at(message.channel);
    if (subscription.depth != kAll && left > subscription.depth) continue;
    const bool is_good = subscription.handler(*message.bytes);
    ++(is_good ? num_handled_ : num_rejected_)[message.channel];
  }
}

void Stepper::PublishStatus() {
  status_t status{};
  status.header.utime = now();
  status.service = params_.name;
  for (const auto& [prefix, counts] :
       {std::pair{"handled:", &num_handled_}, {"rejected:", &num_rejected_}}) {
    for (const auto& [channel, count] : *counts) {
      counter_t& counter = status.counters.emplace_back();
      counter.name = prefix + channel;
      counter.value = count;
    }
  }
  status.num_counters = static_cast<int32_t>(status.counters.size());
  Publish(kStatusChannel, status);
}

}  // namespace cell
