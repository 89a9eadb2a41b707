#include "services/library/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cell/store_answer_t.hpp"
#include "cell/tick_t.hpp"
#include "common/actions/record_messages.h"
#include "common/bus/decode.h"

namespace cell::library {
namespace {

constexpr char kName[] = "library";

int8_t OutcomeOf(const Refusal& refusal) {
  switch (refusal.kind) {
    case Refusal::Kind::kDuplicate:
      return store_answer_t::DUPLICATE;
    case Refusal::Kind::kTooLarge:
      return store_answer_t::TOO_LARGE;
    case Refusal::Kind::kInvalid:
      break;
  }
  return store_answer_t::INVALID;
}

}  // namespace

Library::Library(Bus& bus, std::shared_ptr<ActionStore> store,
                 RecordCheck check)
    : bus_(bus), store_(std::move(store)), check_(std::move(check)) {
  bus_.SubscribeBytes("TICK", 1, [this](auto bytes) { return OnTick(bytes); });
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<library_request_t>(
      bus_, "LIBRARY_REQUEST", [this](const auto& m) { return OnRequest(m); });
  AnswerCommands<command_library_t>(
      bus_, "COMMAND_LIBRARY", [this](const auto& m) { return OnCommand(m); });
  bus_.Subscribe<action_record_t>("STORE_REQUEST",
                                  [this](const auto& m) { OnStoreRequest(m); });
}

/// In its tick of joining, the service receives nothing but this TICK.
bool Library::OnTick(std::span<const uint8_t> bytes) {
  if (std::exchange(has_joined_, true)) return true;
  const auto tick = Decode<tick_t>(bytes);
  if (!tick) return false;
  const auto self =
      std::find_if(tick->joined.begin(), tick->joined.end(),
                   [](const joined_t& joined) { return joined.name == kName; });
  if (self == tick->joined.end()) return true;
  // An incarnation that ended in tick 0 had received nothing yet.
  if (self->death_tick > 0) {
    store_->RollBackTo(self->death_tick);
  } else {
    store_->BeginRun();
  }
  return true;
}

bool Library::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins || event == EpisodeEvent::kJoins) {
    PublishAll(message.header.utime);
  }
  return event.has_value();
}

CommandAnswer Library::OnRequest(const library_request_t& message) {
  if (message.id == 0) {
    PublishAll(message.header.utime);
    return CommandAnswer::Accept("all actions follow on ACTION_RECORD");
  }
  const auto record = store_->Find(message.id);
  if (!record) {
    return CommandAnswer::Refuse("the library has no action with id " +
                                 std::to_string(message.id) +
                                 " (cell library list)");
  }
  Publish(*record, message.header.utime);
  return CommandAnswer::Accept(record->name + " follows on ACTION_RECORD");
}

CommandAnswer Library::OnCommand(const command_library_t& message) {
  const auto records = EditOf(message);
  if (!records) return CommandAnswer::Refuse(records.reason());
  if (const auto why = WhyNotAll(*records, check_, *store_); !why.empty()) {
    return CommandAnswer::Refuse(why);
  }
  const auto ids = store_->Store(*records, bus_.tick());
  std::string names;
  for (size_t i = 0; i < ids.size(); ++i) {
    Publish(*store_->Find(ids[i]), message.header.utime);
    names += (i > 0 ? ", " : "") + (*records)[i].name +
             ((*records)[i].is_removed() ? " (removed)" : "");
  }
  return CommandAnswer::Accept("changed: " + names);
}

Result<RecordEdits::Records> Library::EditOf(
    const command_library_t& message) const {
  const auto content = store_->All();
  const RecordEdits edits(content, check_.domain(), check_.parts());
  switch (message.kind) {
    case command_library_t::RENAME:
      return edits.Rename(message.name, message.other);
    case command_library_t::REMOVE:
      return edits.Remove(message.name);
    case command_library_t::MERGE:
      return edits.Merge(message.name, message.other);
    case command_library_t::TAKE_BACK:
      return edits.TakeBack(message.name);
    case command_library_t::ROLL_BACK:
      return edits.Restore(store_->BeforeRun());
    default:
      return Reason{
          fmt::format("there is no kind {} of change", int{message.kind})};
  }
}

void Library::OnStoreRequest(const action_record_t& message) {
  store_answer_t answer{};
  answer.header.utime = message.header.utime;
  answer.channel = "STORE_REQUEST";
  answer.request_sender = message.header.sender;
  answer.request_seq = message.header.seq;
  ActionRecord record = FromMessage(message);
  if (const auto refusal = check_.WhyNot(record, *store_)) {
    answer.outcome = OutcomeOf(*refusal);
    answer.id = refusal->known_id;
    answer.reason = refusal->reason;
    bus_.Publish("STORED", answer);
    return;
  }
  record.id = store_->Store({&record, 1}, bus_.tick()).front();
  answer.outcome = store_answer_t::STORED;
  answer.id = record.id;
  bus_.Publish("STORED", answer);
  Publish(record, message.header.utime);
}

void Library::Publish(const ActionRecord& record, int64_t utime) {
  action_record_t message = ToMessage(record);
  message.header.utime = utime;
  bus_.Publish("ACTION_RECORD", message);
}

void Library::PublishAll(int64_t utime) {
  for (const ActionRecord& record : store_->All()) Publish(record, utime);
}

std::unique_ptr<Service> MakeLibrary(Bus& bus, const Deployment& deployment,
                                     std::shared_ptr<ActionStore> store) {
  // In a live cell nothing is removed: what is stored has been answered.
  if (deployment.is_live) store->BeginRun();
  RecordCheck check = RecordCheck::FromTask(deployment);
  if (const auto why = check.WhyOfAnotherTask(*store)) {
    throw StoreError(
        "the library's " + *why +
        "; it was stored for another task, or by a build that says this "
        "otherwise: name another --database, or use that build");
  }
  return std::make_unique<Library>(bus, std::move(store), std::move(check));
}

}  // namespace cell::library
