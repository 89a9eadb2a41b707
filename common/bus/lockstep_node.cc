#include "common/bus/lockstep_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cell/types_digest.h"
#include "common/bus/bus_error.h"
#include "common/bus/manifest.h"

namespace cell {

LockstepNode::LockstepNode(const Roster& roster, const std::string& name,
                           int64_t nonce, const ServiceFactory& factory,
                           Link link)
    : name_(name),
      index_(roster.RequireIndexOf(name)),
      nonce_(nonce),
      link_(std::move(link)),
      stepper_({.name = name,
                .truth_role = roster.entries[index_].truth_role,
                .latency = roster.entries[index_].latency,
                .status_phase =
                    static_cast<int32_t>(index_) % Stepper::kStatusPeriod}),
      service_(factory(stepper_)) {}

hello_t LockstepNode::Hello() const {
  hello_t hello{};
  hello.name = name_;
  hello.nonce = nonce_;
  hello.types_digest = kTypesDigest;
  return hello;
}

void LockstepNode::PutTick(const tick_t& tick) {
  if (!IsSound(tick.flows)) return;
  if (has_joined() && tick.run != run_) {
    throw BusError(fmt::format(
        "{}: hears a second cell on this port (TICK {} of another run); give "
        "each cell its own port (--url)",
        name_, tick.header.tick));
  }
  for (const joined_t& joined : tick.joined) {
    if (joined.name != name_) continue;
    if (joined.nonce == nonce_ && !has_joined()) {
      run_ = tick.run;
      sender_ = joined.sender;
      stepper_.set_sender(sender_);
      join_tick_ = next_tick_ = tick.header.tick;
    } else if (joined.nonce != nonce_ && has_joined()) {
      throw BusError(
          name_ +
          ": another process has joined under this name; "
          "run each service once, each cell on its own port (--url)");
    }
  }
  if (!has_joined()) return;
  if (tick.header.tick >= next_tick_) {
    ticks_.try_emplace(tick.header.tick, tick);
  } else {
    ++num_repeats_;
    if (last_ack_) link_.send_ack(*last_ack_);
  }
}

std::vector<MessageId> LockstepNode::NeededBy(const tick_t& tick) const {
  if (tick.header.tick == join_tick_) return {};
  std::vector<MessageId> ids = MessagesIn(tick.flows);
  std::erase_if(ids,
                [this](const MessageId& id) { return !Wants(id.channel); });
  return ids;
}

bool LockstepNode::Advance() {
  if (is_done_ || !has_joined()) return false;
  const auto it = ticks_.find(next_tick_);
  if (it == ticks_.end()) return false;
  auto inputs = inbox_.Take(NeededBy(it->second));
  if (!inputs) return false;
  const tick_t tick = std::move(it->second);
  ticks_.erase(it);
  ++next_tick_;
  Handle(tick, std::move(*inputs));
  inbox_.Purge(tick.header.tick - 1);
  is_done_ = tick.is_last != 0;
  return true;
}

void LockstepNode::Handle(const tick_t& tick, std::vector<Message> inputs) {
  if (Wants(kTickChannel)) inputs.push_back(TickMessage(tick));
  ack_t ack = NewAck(tick.header.tick);
  switch (stepper_.Accept(tick.header.tick, std::move(inputs))) {
    case Stepper::State::kWaiting:
      return;  // the ACK of the activation's end answers for this tick
    case Stepper::State::kIdle:
      return SendAck(std::move(ack));
    case Stepper::State::kReady:
      break;
  }
  const int32_t until = stepper_.until();
  if (until > tick.header.tick) {
    ack.is_busy = 1;
    ack.until = until;
    SendAck(ack);
  }
  const std::vector<Message> outputs = stepper_.Run();
  for (const Message& message : outputs) link_.send_data(message);
  ack_t done = NewAck(until);
  done.flows = FlowsOf(outputs);
  done.num_flows = static_cast<int32_t>(done.flows.size());
  SendAck(std::move(done));
}

ack_t LockstepNode::NewAck(int32_t tick) const {
  ack_t ack{};
  ack.header.tick = ack.until = tick;
  ack.header.sender = sender_;
  ack.run = run_;
  ack.nonce = nonce_;
  return ack;
}

void LockstepNode::SendAck(ack_t ack) {
  last_ack_ = std::move(ack);
  link_.send_ack(*last_ack_);
}

std::optional<std::string> LockstepNode::MissingData() const {
  if (is_done_ || !ticks_.contains(next_tick_) || !inbox_.missing()) {
    return std::nullopt;
  }
  return fmt::format(
      "{} {}: tick {} needs channel {}{} (check recv_buf_size and "
      "net.core.rmem_max)",
      inbox_.is_corrupt() ? "CORRUPT" : "LOST", name_, next_tick_,
      ToString(*inbox_.missing()),
      inbox_.is_corrupt() ? ", which came with other bytes" : "");
}

}  // namespace cell
