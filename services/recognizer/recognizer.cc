#include "services/recognizer/recognizer.h"

#include <numbers>
#include <utility>

#include "cell/action_t.hpp"
#include "cell/library_request_t.hpp"
#include "common/actions/record_messages.h"
#include "common/scene/key_frame.h"
#include "common/sec/condition_library.h"
#include "common/task/task.h"

namespace cell::recognizer {
namespace {

action_t ToMessage(const RecognisedAction& action, int64_t index) {
  action_t message{};
  message.header.utime = action.place_utime;
  message.index = index;
  message.kind = static_cast<int8_t>(action.direction);
  message.name = action.name;
  message.arguments = action.arguments;
  message.num_arguments = static_cast<int32_t>(action.arguments.size());
  message.part = action.part;
  message.hands = action.hands;
  message.num_hands = static_cast<int32_t>(action.hands.size());
  message.pick_utime = action.pick_utime;
  message.pick_key_frame = action.pick_key_frame;
  message.place_key_frame = action.place_key_frame;
  return message;
}

/// The models that were written by hand are the only ones yet.
std::shared_ptr<const SecLibrary> MakeConditionLibrary(
    const ActionModels& actions) {
  std::vector<ConditionLibrary::Entry> entries;
  for (const ActionModel& model : actions.models()) {
    if (!model.sec) continue;
    entries.push_back({model.action.name, model.action.arguments, *model.sec});
  }
  return std::make_shared<const ConditionLibrary>(
      std::move(entries), actions.domain().vocabulary(), actions.parts());
}

}  // namespace

Recognizer::Recognizer(Bus& bus, const Params& params)
    : bus_(bus), params_(params), actions_(params.actions) {
  Begin();
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<key_frame_t>(
      "KEY_FRAME", [this](const key_frame_t& m) { return OnKeyFrame(m); });
  bus.Subscribe<action_record_t>(
      "ACTION_RECORD",
      [this](const action_record_t& m) { return OnRecord(m); });
}

void Recognizer::Begin() {
  recognition_ = std::make_unique<Recognition>(
      params_.scene_objects, actions_.parts(), params_.make_library(actions_),
      params_.sensor, params_.recognition);
  last_key_frame_ = -1;
  next_index_ = 0;
}

bool Recognizer::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) Begin();
  if (event == EpisodeEvent::kJoins) {
    library_request_t all{};
    all.header.utime = bus_.now();
    bus_.Publish("LIBRARY_REQUEST", all);
  }
  return event.has_value();
}

bool Recognizer::OnKeyFrame(const key_frame_t& message) {
  const auto frame = KeyFrameFromMessage(message, params_.scene_objects);
  if (!frame || frame->index <= last_key_frame_) return false;
  if (episode_.IsBefore(frame->utime)) return true;
  last_key_frame_ = frame->index;
  for (const RecognisedAction& action : recognition_->Update(*frame)) {
    bus_.Publish("ACTION", ToMessage(action, next_index_++));
  }
  return true;
}

bool Recognizer::OnRecord(const action_record_t& message) {
  const auto update = actions_.Take(FromMessage(message));
  if (update && *update == ActionModels::Update::kChanged) {
    recognition_->Use(params_.make_library(actions_));
  }
  return bool(update);
}

std::unique_ptr<Service> MakeRecognizer(Bus& bus,
                                        const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  Recognizer::Params params{task.scene_objects,
                            {task.domain, task.parts, task.actions},
                            MakeConditionLibrary,
                            task.MakeSensor(),
                            {}};
  const Config config = deployment.ForService("recognizer");
  params.recognition.moved = config.Number("moved_mm", 0, 1000) * 1e-3;
  params.recognition.turned =
      config.Number("turned_deg", 0, 180) * std::numbers::pi / 180;
  config.Finish();
  return std::make_unique<Recognizer>(bus, params);
}

}  // namespace cell::recognizer
