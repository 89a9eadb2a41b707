#include "common/bus/live_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/bus/command_gate.h"
#include "common/bus/decode.h"
#include "common/bus/event_log.h"
#include "common/bus/live_node.h"
#include "common/bus/run_log.h"

namespace cell {
namespace {

bool IsSoundStep(const step_t& step) {
  return step.header.seq >= 0 && step.header.sender >= 0 &&
         std::all_of(step.flows.begin(), step.flows.end(), [](const flow_t& f) {
           return f.count > 0 && f.first_seq >= 0 && f.sender >= 0 &&
                  f.first_seq <= INT32_MAX - f.count;
         });
}

std::string NameOf(int32_t sender, const Roster& roster) {
  const auto index = static_cast<size_t>(BaseOf(sender));
  return index < roster.entries.size() ? roster.entries[index].name
                                       : fmt::format("sender {}", sender);
}

// The seqs between the first and the last that are not there, as "20" and
// "22 to 25".
std::vector<std::string> GapsIn(const std::set<int32_t>& seqs) {
  std::vector<std::string> gaps;
  for (auto it = seqs.begin(); it != seqs.end(); ++it) {
    const auto next = std::next(it);
    if (next == seqs.end() || *next == *it + 1) continue;
    gaps.push_back(*next == *it + 2
                       ? fmt::format("{}", *it + 1)
                       : fmt::format("{} to {}", *it + 1, *next - 1));
  }
  return gaps;
}

}  // namespace

bool LiveLog::IsLive(const std::vector<std::filesystem::path>& logs) {
  for (const auto& log : logs) {
    EventLogReader reader(log);
    reader.Finish();
    while (const auto event = reader.Next()) {
      if (event->channel == kTickChannel) return false;
      if (event->channel == kStepChannel) return true;
    }
  }
  return false;
}

LiveLog LiveLog::Load(const std::filesystem::path& run_dir) {
  return Load(RequireLogsOf(run_dir));
}

LiveLog LiveLog::Load(const std::vector<std::filesystem::path>& logs) {
  LiveLog live;
  for (const auto& log : logs) live.Read(log);
  if (live.incarnations_.empty()) {
    throw std::runtime_error(logs.front().string() + ": holds no STEP");
  }
  for (auto& [sender, steps] : live.incarnations_) {
    std::sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) {
      return a.header.seq < b.header.seq;
    });
  }
  return live;
}

void LiveLog::Read(const std::filesystem::path& log) {
  EventLogReader reader(log);
  reader.Finish();
  while (auto event = reader.Next()) {
    const auto message =
        MessageFromWire(event->channel, std::move(event->bytes));
    if (!message) continue;  // another program's, e.g. LCM_SELF_TEST
    auto& duplicates =
        messages_[{message->channel, message->sender, message->seq}];
    const bool is_known = std::any_of(
        duplicates.begin(), duplicates.end(), [&](const Message& duplicate) {
          return duplicate.digest == message->digest;
        });
    if (is_known) continue;
    duplicates.push_back(*message);
    if (message->channel != kStepChannel) continue;
    auto step = Decode<step_t>(*message);
    if (step && IsSoundStep(*step)) {
      incarnations_[message->sender].push_back(*std::move(step));
    }
  }
  for (const auto& range : reader.corrupt_ranges()) {
    corrupt_ranges_.push_back(
        fmt::format("{}: {} bytes from byte {} on are damaged", log.string(),
                    range.length, range.offset));
  }
}

const Message* LiveLog::Find(const MessageId& id) const {
  const auto it = messages_.find({id.channel, id.sender, id.seq});
  if (it == messages_.end()) return nullptr;
  for (const Message& duplicate : it->second) {
    if (duplicate.digest == id.digest) return &duplicate;
  }
  return nullptr;
}

std::vector<const Message*> LiveLog::SaidBy(int32_t sender) const {
  std::vector<const Message*> said;
  for (const auto& [id, duplicates] : messages_) {
    const auto& [channel, of, seq] = id;
    if (of != sender || channel == kStepChannel || IsCommand(channel)) continue;
    for (const Message& duplicate : duplicates) said.push_back(&duplicate);
  }
  return said;
}

std::vector<const Message*> LiveLog::InOrder() const {
  std::vector<const Message*> messages;
  for (const auto& [id, duplicates] : messages_) {
    for (const Message& duplicate : duplicates) messages.push_back(&duplicate);
  }
  std::sort(
      messages.begin(), messages.end(),
      [](const Message* a, const Message* b) { return OrderedBefore(*a, *b); });
  return messages;
}

std::vector<std::string> LiveLog::Problems(const Roster& roster) const {
  std::vector<std::string> problems = corrupt_ranges_;
  std::map<std::pair<std::string, int32_t>, std::set<int32_t>> recorded;
  for (const auto& [id, duplicates] : messages_) {
    const auto& [channel, sender, seq] = id;
    if (static_cast<size_t>(BaseOf(sender)) < roster.entries.size()) {
      recorded[{channel, sender}].insert(seq);
    }
  }
  for (const auto& [flow, seqs] : recorded) {
    for (const std::string& gap : GapsIn(seqs)) {
      problems.push_back(fmt::format("the log lacks {} sender {} ({}) seq {}",
                                     flow.first, flow.second,
                                     NameOf(flow.second, roster), gap));
    }
  }
  for (const auto& [incarnation, steps] : incarnations_) {
    std::map<std::pair<std::string, int32_t>, std::set<int32_t>> given;
    for (const step_t& step : steps) {
      for (const MessageId& id : MessagesIn(step.flows)) {
        given[{id.channel, id.sender}].insert(id.seq);
      }
    }
    for (const auto& [flow, seqs] : given) {
      for (const std::string& gap : GapsIn(seqs)) {
        problems.push_back(
            fmt::format("{} did not get {} sender {} ({}) seq {}",
                        NameOf(incarnation, roster), flow.first, flow.second,
                        NameOf(flow.second, roster), gap));
      }
    }
  }
  return problems;
}

std::vector<std::string> LiveLog::LateMessages(const Roster& roster) const {
  std::vector<std::string> late;
  for (const auto& [incarnation, steps] : incarnations_) {
    for (const step_t& step : steps) {
      for (const MessageId& id : MessagesIn(step.flows)) {
        const Message* message = Find(id);
        if (message == nullptr) continue;
        const int32_t delay = TicksLate(*message, step.header.tick);
        if (delay <= 0) continue;
        late.push_back(fmt::format("tick {}: {} got {} {} {} late",
                                   step.header.tick,
                                   NameOf(incarnation, roster), ToString(id),
                                   delay, delay == 1 ? "tick" : "ticks"));
      }
    }
  }
  return late;
}

}  // namespace cell
