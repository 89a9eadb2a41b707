#include "common/bus/live_node.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cell/step_t.hpp"
#include "common/bus/manifest.h"

namespace cell {
namespace {

/// Memory for the messages of one activation; an honest cell needs less.
constexpr size_t kMaxBytes = 64u << 20;
constexpr size_t kMaxCommands = 100;

// Like FlowsOf(), but seqs may be missing: a flow ends at a gap.
std::vector<flow_t> FlowsWithGaps(const std::vector<Message>& messages) {
  std::vector<flow_t> flows;
  for (const Message& message : messages) {
    const bool is_next =
        !flows.empty() && flows.back().channel == message.channel &&
        flows.back().sender == message.sender &&
        flows.back().first_seq + flows.back().count == message.seq;
    if (!is_next) {
      flow_t& flow = flows.emplace_back();
      flow.channel = message.channel;
      flow.sender = message.sender;
      flow.first_seq = message.seq;
      flow.count = 0;
    }
    flows.back().digests.push_back(message.digest);
    ++flows.back().count;
  }
  return flows;
}

}  // namespace

int32_t TicksLate(const Message& message, int32_t tick) {
  return tick - message.tick - (BaseOf(message.sender) == 0 ? 0 : 1);
}

Stepper::Params LiveStepperParams(const Roster& roster, size_t index,
                                  int32_t sender) {
  Stepper::Params params = StepperParams(roster, index, sender);
  params.latency = 1;
  params.skips_ticks = true;
  return params;
}

// A service that takes every channel, a recorder, would journal the journals.
LiveNode::LiveNode(const Roster& roster, const std::string& name,
                   int32_t incarnation, const ServiceFactory& factory,
                   Send send)
    : send_(std::move(send)),
      stepper_(LiveStepperParams(
          roster, roster.RequireIndexOf(name),
          SenderOf(roster.RequireIndexOf(name), incarnation))),
      service_(factory(stepper_)),
      arrivals_(roster.entries.size()),
      is_journaled_(!stepper_.Wants(kStepChannel)) {}

void LiveNode::Put(Message message) {
  // The first service has already received the commands that it forwards.
  const bool is_own_command =
      IsCommand(message.channel) && BaseOf(sender()) == 0;
  if (!Wants(message.channel) || is_own_command ||
      num_bytes_ + message.bytes->size() > kMaxBytes ||
      !arrivals_.Accept(message)) {
    return;
  }
  num_bytes_ += message.bytes->size();
  inbox_.push_back(std::move(message));
}

void LiveNode::Put(Command command) {
  if (commands_.size() < kMaxCommands) commands_.push_back(std::move(command));
}

void LiveNode::Step(int32_t tick) {
  num_bytes_ = 0;
  std::vector<Message> inputs = std::exchange(inbox_, {});
  for (const Message& message : inputs) {
    if (TicksLate(message, tick) > 0) ++num_late_[message.channel];
  }
  for (const Message& command : gate_.Pass(
           tick, sender(), std::exchange(commands_, {}),
           [this](const std::string& channel) { return Wants(channel); })) {
    send_(command);
    if (Wants(command.channel)) inputs.push_back(command);
  }
  std::sort(inputs.begin(), inputs.end(), OrderedBefore);
  const bool is_ready = stepper_.Accept(tick, inputs) == Stepper::State::kReady;
  if (is_journaled_ && (is_ready || next_step_ == 0)) PublishStep(tick, inputs);
  if (!is_ready) return;
  for (const Message& message : stepper_.Run()) send_(message);
}

void LiveNode::PublishStep(int32_t tick, const std::vector<Message>& inputs) {
  step_t step{};
  step.header.utime = int64_t{tick} * kTickUs;
  step.flows = FlowsWithGaps(inputs);
  step.num_flows = static_cast<int32_t>(step.flows.size());
  Bytes bytes = Bus::Encode(step);
  WriteIdentity(tick, sender(), next_step_++, bytes);
  send_(*MessageFromWire(kStepChannel, std::move(bytes)));
}

}  // namespace cell
