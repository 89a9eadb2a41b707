#include "common/bus/sim_bus.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cell/types_digest.h"
#include "common/bus/bus_error.h"
#include "common/bus/manifest.h"

namespace cell {
namespace {

const ServiceFactory& FactoryOf(
    const std::map<std::string, ServiceFactory>& factories,
    const std::string& name) {
  const auto it = factories.find(name);
  if (it == factories.end()) {
    throw std::invalid_argument("no factory for the roster's service '" + name +
                                "'");
  }
  return it->second;
}

// A SimBus has one run, and numbers its incarnations: no id has to be random.
constexpr int64_t kRun = 1;
int64_t NonceOf(size_t index, int32_t incarnation) {
  return SenderOf(index, incarnation) + 1;
}

}  // namespace

SimBus::SimBus(const Roster& roster,
               std::map<std::string, ServiceFactory> factories,
               std::vector<Outage> outages, std::vector<TimedCommand> commands)
    : roster_(roster),
      factories_(std::move(factories)),
      commands_(std::move(commands)),
      host_(roster_, FactoryOf(factories_, roster_.entries[0].name)),
      clock_(roster_, kRun),
      slots_(roster_.entries.size()) {
  for (const Outage& outage : outages) Add(outage);
  for (size_t i = 1; i < slots_.size(); ++i) {
    NewIncarnation(i, 0);
  }
}

void SimBus::Add(const Outage& outage) {
  if (roster_.IndexOf(outage.service).value_or(0) == 0 ||
      outage.join_tick < outage.death_tick || outage.death_tick < 0) {
    throw std::invalid_argument("impossible outage of '" + outage.service +
                                "' at tick " +
                                std::to_string(outage.death_tick));
  }
  outages_.push_back(outage);
}

void SimBus::Schedule(const Outage& outage) {
  if (outage.death_tick <= clock_.tick()) {
    throw std::invalid_argument("an outage of '" + outage.service +
                                "' in a tick that is over");
  }
  Add(outage);
}

void SimBus::Schedule(const TimedCommand& command) {
  if (command.tick <= clock_.tick()) {
    throw std::invalid_argument("a command on '" + command.command.channel +
                                "' in a tick that is over");
  }
  commands_.push_back(command);
}

bool SimBus::Step() {
  if (last_tick_.is_last) return false;
  const int32_t tick = clock_.tick() + 1;
  BeginOutagesAndIncarnations(tick);
  if (const auto error =
          clock_.UndeclaredFeeder([this](const std::string& channel) {
            return host_.Wants(channel);
          })) {
    throw BusError(*error);
  }

  std::vector<Message> inputs;
  for (const Message& message : published_) {
    if (host_.Wants(message.channel)) inputs.push_back(message);
  }
  std::vector<Message> messages =
      host_.Tick(tick, std::move(inputs), CommandsOf(tick));
  last_tick_ = clock_.Advance(messages, host_.IsLast(tick));
  for (size_t i = 1; i < slots_.size(); ++i) {
    if (slots_[i].is_silent) clock_.MarkDead(i);
  }
  messages.insert(messages.end(), std::make_move_iterator(published_.begin()),
                  std::make_move_iterator(published_.end()));
  published_.clear();
  last_messages_ = std::move(messages);
  for (size_t i = 1; i < slots_.size(); ++i) {
    Handle(i, last_tick_, last_messages_);
  }
  return true;
}

void SimBus::BeginOutagesAndIncarnations(int32_t tick) {
  for (const Outage& outage : outages_) {
    const size_t index = *roster_.IndexOf(outage.service);
    // Outputs of an activation that death cut short are void.
    if (tick == outage.death_tick) {
      slots_[index].is_silent = true;
      slots_[index].pending.clear();
    }
    if (tick == outage.join_tick) NewIncarnation(index, tick);
  }
}

void SimBus::NewIncarnation(size_t index, int32_t tick) {
  Slot& slot = slots_[index];
  const Roster::Entry& entry = roster_.entries[index];
  const int32_t incarnation = slot.incarnation + 1;
  slot = Slot{};
  slot.incarnation = incarnation;
  slot.join_tick = tick;
  slot.stepper = std::make_unique<Stepper>(
      StepperParams(roster_, index, SenderOf(index, incarnation)));
  slot.service = FactoryOf(factories_, entry.name)(*slot.stepper);
  hello_t hello{};
  hello.name = entry.name;
  hello.nonce = NonceOf(index, incarnation);
  hello.types_digest = kTypesDigest;
  clock_.Hello(hello);
}

void SimBus::Handle(size_t index, const tick_t& tick,
                    const std::vector<Message>& messages) {
  Slot& slot = slots_[index];
  if (slot.is_silent) return;
  std::vector<Message> inputs;
  if (tick.header.tick != slot.join_tick) {
    for (const Message& message : messages) {
      if (slot.stepper->Wants(message.channel)) inputs.push_back(message);
    }
  }
  if (slot.stepper->Wants(kTickChannel)) inputs.push_back(TickMessage(tick));

  const int32_t k = tick.header.tick;
  switch (slot.stepper->Accept(k, std::move(inputs))) {
    case Stepper::State::kWaiting:
      break;
    case Stepper::State::kIdle:
      clock_.Ack(NewAck(index, k));
      return;
    case Stepper::State::kReady:
      slot.pending = slot.stepper->Run();
      slot.until = slot.stepper->until();
      if (k < slot.until) {
        ack_t busy = NewAck(index, k);
        busy.is_busy = 1;
        busy.until = slot.until;
        clock_.Ack(busy);
      }
  }
  if (k < slot.until) return;
  ack_t done = NewAck(index, k);
  done.flows = FlowsOf(slot.pending);
  done.num_flows = static_cast<int32_t>(done.flows.size());
  clock_.Ack(done);
  published_.insert(published_.end(),
                    std::make_move_iterator(slot.pending.begin()),
                    std::make_move_iterator(slot.pending.end()));
  slot.pending.clear();
}

ack_t SimBus::NewAck(size_t index, int32_t tick) const {
  ack_t ack{};
  ack.header.tick = ack.until = tick;
  ack.header.sender = SenderOf(index, slots_[index].incarnation);
  ack.run = kRun;
  ack.nonce = NonceOf(index, slots_[index].incarnation);
  return ack;
}

std::vector<Command> SimBus::CommandsOf(int32_t tick) {
  std::vector<Command> due;
  for (const TimedCommand& timed : commands_) {
    if (timed.tick == tick) due.push_back(timed.command);
  }
  return due;
}

}  // namespace cell
