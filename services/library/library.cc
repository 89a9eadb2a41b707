#include "services/library/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cell/store_answer_t.hpp"
#include "cell/tick_t.hpp"
#include "common/actions/record_messages.h"
#include "common/bus/decode.h"
#include "common/text/counted.h"

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

/// "Insert, Action1 (removed), 3 experiences"
std::string Summary(const StoreEdit& edit) {
  std::string names;
  for (const ActionRecord& record : edit.records) {
    names += (names.empty() ? "" : ", ") + record.name +
             (record.is_removed() ? " (removed)" : "");
  }
  if (!edit.has_experiences()) return names;
  // One that moves is removed, and stored anew.
  const auto num = static_cast<int64_t>(
      std::max(edit.experiences.size(), edit.removed_experiences.size()));
  return names + (names.empty() ? "" : ", ") + Counted(num, "experience");
}

}  // namespace

Library::Library(Bus& bus, std::shared_ptr<ActionStore> store,
                 RecordCheck check)
    : bus_(bus),
      store_(std::move(store)),
      check_(std::move(check)),
      experience_check_(check_.domain().vocabulary()) {
  bus_.SubscribeBytes("TICK", 1, [this](auto bytes) { return OnTick(bytes); });
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<library_request_t>(
      bus_, "LIBRARY_REQUEST", [this](const auto& m) { return OnRequest(m); });
  AnswerCommands<command_library_t>(
      bus_, "COMMAND_LIBRARY", [this](const auto& m) { return OnCommand(m); });
  bus_.Subscribe<action_record_t>("STORE_REQUEST",
                                  [this](const auto& m) { OnStoreRequest(m); });
  bus_.Subscribe<experience_t>(
      "EXPERIENCE_REQUEST", [this](const auto& m) { OnExperienceRequest(m); });
  bus_.Every(1, 0, [this] { PublishExperiences(); });
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
    demonstration_ = fmt::format("{} {}", message.demonstration, message.seed);
    PublishAll(message.header.utime);
  }
  return event.has_value();
}

CommandAnswer Library::OnRequest(const library_request_t& message) {
  if (message.id == 0) {
    PublishAll(message.header.utime);
    return CommandAnswer::Accept(
        "all actions follow on ACTION_RECORD, and all experiences on "
        "EXPERIENCE");
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
  const auto edit = EditOf(message);
  if (!edit) return CommandAnswer::Refuse(edit.reason());
  if (const auto why = WhyNotAll(edit->records, check_, *store_);
      !why.empty()) {
    return CommandAnswer::Refuse(why);
  }
  const StoredIds ids = store_->Apply(*edit, bus_.tick());
  const int64_t utime = message.header.utime;
  for (const int64_t id : ids.records) Publish(*store_->Find(id), utime);
  for (const int64_t id : edit->removed_experiences) PublishRemoval(id, utime);
  for (const int64_t id : ids.experiences) {
    Publish(store_->ExperiencesFrom(id, 1).front(), utime);
  }
  return CommandAnswer::Accept("changed: " + Summary(*edit));
}

Result<StoreEdit> Library::EditOf(const command_library_t& message) const {
  const LibraryContent content = store_->Content();
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
  next_told_ = 1;
  told_utime_ = utime;
}

void Library::OnExperienceRequest(const experience_t& message) {
  store_answer_t answer{};
  answer.header.utime = message.header.utime;
  answer.channel = "EXPERIENCE_REQUEST";
  answer.request_sender = message.header.sender;
  answer.request_seq = message.header.seq;
  if (const auto refusal = experience_check_.WhyNot(message, *store_)) {
    answer.outcome = OutcomeOf(*refusal);
    answer.reason = refusal->reason;
    bus_.Publish("STORED", answer);
    return;
  }
  ExperienceRecord experience = ToRecord(message);
  experience.demonstration = demonstration_;
  experience.id = store_->Keep(experience, bus_.tick());
  answer.outcome = store_answer_t::STORED;
  answer.id = experience.id;
  bus_.Publish("STORED", answer);
  Publish(experience, message.header.utime);
}

/// Unless it is not for others to know.
void Library::Publish(const ExperienceRecord& experience, int64_t utime) {
  if (!IsTold(experience)) return;
  experience_t message = ToMessage(experience);
  message.header.utime = utime;
  bus_.Publish("EXPERIENCE", message);
}

void Library::PublishRemoval(int64_t experience, int64_t utime) {
  experience_t message{};
  message.header.utime = utime;
  message.id = experience;
  bus_.Publish("EXPERIENCE", message);
}

/// The next of those that were asked for.
void Library::PublishExperiences() {
  if (!next_told_) return;
  const auto experiences = store_->ExperiencesFrom(*next_told_, kToldPerTick);
  for (const ExperienceRecord& experience : experiences) {
    Publish(experience, told_utime_);
  }
  if (static_cast<int64_t>(experiences.size()) < kToldPerTick) {
    next_told_.reset();
  } else {
    next_told_ = experiences.back().id + 1;
  }
}

bool Library::IsTold(const ExperienceRecord& experience) const {
  const auto action = store_->FindNamed(experience.action);
  return (!action || !action->is_removed()) &&
         experience_check_.IsOfTask(experience);
}

std::unique_ptr<Service> MakeLibrary(Bus& bus, const Deployment& deployment,
                                     std::shared_ptr<ActionStore> store) {
  // In a live cell nothing is removed: what is stored has been answered.
  if (deployment.is_live) store->BeginRun();
  RecordCheck check = RecordCheck::FromTask(deployment);
  auto why = check.WhyOfAnotherTask(*store);
  if (!why) {
    why = ExperienceCheck(check.domain().vocabulary()).WhyOfAnotherTask(*store);
  }
  if (why) {
    throw StoreError(
        "the library's " + *why +
        "; it was stored for another task, or by a build that says this "
        "otherwise: name another --database, or use that build");
  }
  return std::make_unique<Library>(bus, std::move(store), std::move(check));
}

}  // namespace cell::library
