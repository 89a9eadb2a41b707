#include "services/recognizer/recognizer.h"

#include <fmt/format.h>

#include <utility>

#include "cell/alert_t.hpp"
#include "cell/library_request_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "common/actions/record_messages.h"
#include "common/actions/sec_models.h"
#include "common/predicates/pose_noise_config.h"
#include "common/scene/key_frame.h"
#include "common/task/task.h"

namespace cell::recognizer {
namespace {

recognised_action_t ToMessage(const RecognisedAction& action, int64_t index) {
  recognised_action_t message{};
  message.header.utime = action.place_utime;
  message.index = index;
  message.kind = static_cast<int8_t>(action.direction);
  message.name = action.name;
  message.arguments = action.arguments;
  message.num_arguments = static_cast<int32_t>(action.arguments.size());
  message.part = action.part;
  message.hands = action.hands;
  message.num_hands = static_cast<int32_t>(action.hands.size());
  message.confidence = action.confidence;
  message.pick_utime = action.pick_utime;
  message.pick_key_frame = action.pick_key_frame;
  message.place_key_frame = action.place_key_frame;
  return message;
}

}  // namespace

Recognizer::Recognizer(Bus& bus, const Params& params)
    : bus_(bus), params_(params), actions_(params.actions) {
  if (params.new_skill) learning_.emplace(actions_, *params.new_skill);
  Begin();
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<key_frame_t>(
      "KEY_FRAME", [this](const key_frame_t& m) { return OnKeyFrame(m); });
  bus.Subscribe<action_record_t>(
      "ACTION_RECORD",
      [this](const action_record_t& m) { return OnRecord(m); });
  AnswerCommands<command_name_t>(bus, "COMMAND_NAME",
                                 [this](const auto& m) { return OnName(m); });
  if (!learning_) return;
  bus.Subscribe<store_answer_t>("STORED",
                                [this](const auto& m) { OnStored(m); });
  bus.Every(1, 0, [this] { RequestChanges(); });
}

void Recognizer::Begin() {
  recognition_ = std::make_unique<Recognition>(
      params_.scene_objects, actions_.parts(), params_.make_library(actions_),
      params_.sensor, params_.recognition);
  last_key_frame_ = -1;
  next_index_ = 0;
  if (!learning_) return;
  recognition_->SetObserver(
      [this](const auto& manipulation, const auto& actions) {
        Learn(manipulation, actions);
      });
}

bool Recognizer::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins || event == EpisodeEvent::kJoins) {
    demonstration_ = fmt::format("{} {}", message.demonstration, message.seed);
  }
  if (event == EpisodeEvent::kBegins) Begin();
  if (event == EpisodeEvent::kEnds && learning_)
    learning_->OnDemonstrationEnd();
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
  shown_.clear();
  for (const RecognisedAction& action : recognition_->Update(*frame)) {
    recognised_action_t recognised = ToMessage(action, next_index_++);
    const auto shown = shown_.find(action.part);
    if (recognised.kind == recognised_action_t::UNKNOWN &&
        shown != shown_.end()) {
      recognised.name = shown->second.action;
      recognised.arguments = shown->second.arguments;
      recognised.num_arguments =
          static_cast<int32_t>(recognised.arguments.size());
    }
    bus_.Publish("ACTION", recognised);
  }
  return true;
}

bool Recognizer::OnRecord(const action_record_t& message) {
  const auto update = actions_.Apply(FromMessage(message));
  if (update && *update == ActionModels::Update::kChanged) {
    recognition_->Use(params_.make_library(actions_));
    if (learning_) learning_->OnRecord(message.name, actions_);
  }
  return bool(update);
}

CommandAnswer Recognizer::OnName(const command_name_t& message) {
  if (!learning_) {
    return CommandAnswer::Refuse(
        "this cell does not learn; set learning: true in recognizer.yaml");
  }
  const auto text = learning_->Name(message.name, message.is_undone, actions_);
  return text ? CommandAnswer::Accept(*text)
              : CommandAnswer::Refuse(text.reason());
}

void Recognizer::OnStored(const store_answer_t& message) {
  if (message.channel != "STORE_REQUEST" ||
      message.outcome == store_answer_t::STORED) {
    return;
  }
  learning_->OnRefusal();
  alert_t alert{};
  alert.header.utime = bus_.now();
  alert.level = alert_t::WARNING;
  alert.cause = alert_t::BAD_INPUT;
  alert.text = "the library does not keep what was learned: " + message.reason;
  bus_.Publish("ALERT", alert);
}

/// What undoes one action and does another shows neither by itself. Neither
/// does a stand-in: the action would be learned to take anything like it.
void Recognizer::Learn(const ObservedManipulation& manipulation,
                       const std::vector<RecognisedAction>& actions) {
  if (actions.size() > 1 || actions.front().has_stand_in) {
    learning_->OnMixture();
  } else {
    auto shown =
        learning_->OnManipulation(manipulation, demonstration_, actions_);
    if (shown) shown_[manipulation.part] = *std::move(shown);
  }
}

void Recognizer::RequestChanges() {
  for (const ActionRecord& record : learning_->TakeChanges(actions_)) {
    action_record_t message = ToMessage(record);
    message.header.utime = bus_.now();
    bus_.Publish("STORE_REQUEST", message);
  }
}

Recognizer::Params Recognizer::Params::Load(const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  Params params{task.scene_objects,
                {task.domain, task.parts, task.actions},
                cell::MakeSecLibrary,
                nullptr,
                {},
                {}};
  const Config config = deployment.ForService("recognizer");
  params.recognition = Recognition::Params::Load(config);
  params.sensor = task.MakeSensor(ReadPoseNoise(config));
  if (config.Get<bool>("learning")) {
    params.new_skill.emplace(task.domain.vocabulary(), task.geometries,
                             task.layout);
  }
  config.Finish();
  return params;
}

std::unique_ptr<Service> MakeRecognizer(Bus& bus,
                                        const Deployment& deployment) {
  return std::make_unique<Recognizer>(bus,
                                      Recognizer::Params::Load(deployment));
}

}  // namespace cell::recognizer
