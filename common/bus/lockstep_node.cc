#include "common/bus/lockstep_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cell/types_digest.h"
#include "common/bus/bus_error.h"
#include "common/bus/manifest.h"

namespace cell {
namespace {

// More than any service's latency.
constexpr int32_t kMaxAhead = 2000;

}  // namespace

LockstepNode::LockstepNode(const Roster& roster, const std::string& name,
                           int64_t nonce, const ServiceFactory& factory,
                           Link link)
    : name_(name),
      nonce_(nonce),
      link_(std::move(link)),
      stepper_(StepperParams(roster, roster.RequireIndexOf(name), 0)),
      service_(factory(stepper_)) {}

void LockstepNode::PutData(Message message) {
  // A message that is stamped so far ahead is not of this cell.
  if (has_joined() && message.tick >= next_tick_ + kMaxAhead) return;
  inbox_.Put(std::move(message));
}

hello_t LockstepNode::Hello() const {
  hello_t hello{};
  hello.name = name_;
  hello.nonce = nonce_;
  hello.types_digest = kTypesDigest;
  return hello;
}

void LockstepNode::PutTick(tick_t tick) {
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
  if (!has_joined()) return inbox_.Purge(tick.header.tick);
  if (tick.header.tick >= next_tick_) {
    if (tick.header.tick < next_tick_ + kMaxAhead) {
      const int32_t number = tick.header.tick;
      ticks_.try_emplace(number, std::move(tick));
    }
  } else {
    ++num_repeats_;
    if (last_ack_) link_.send_ack(*last_ack_);
  }
}

std::vector<MessageId> LockstepNode::NeededBy(const tick_t& tick) const {
  if (tick.header.tick == join_tick_) return {};
  return MessagesIn(tick.flows, [this](const std::string& channel) {
    return Wants(channel);
  });
}

bool LockstepNode::Advance() {
  if (is_done_ || !has_joined()) return false;
  const auto it = ticks_.find(next_tick_);
  if (it == ticks_.end()) return false;
  auto inputs = inbox_.Pop(NeededBy(it->second));
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
      // The ACK of the activation's end answers for the ticks before it.
      if (tick.header.tick == stepper_.until()) FinishActivation();
      return;
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
  outputs_ = stepper_.Run();
  if (until == tick.header.tick) FinishActivation();
}

// Not before its last tick: a service that joins meanwhile needs the outputs.
void LockstepNode::FinishActivation() {
  for (const Message& message : outputs_) link_.send_data(message);
  ack_t done = NewAck(stepper_.until());
  done.flows = FlowsOf(outputs_);
  done.num_flows = static_cast<int32_t>(done.flows.size());
  outputs_.clear();
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
