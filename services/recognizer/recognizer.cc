#include "services/recognizer/recognizer.h"

#include <numbers>

#include "cell/action_t.hpp"
#include "common/layout/cell_layout.h"
#include "common/sec/key_frame.h"

namespace cell::recognizer {
namespace {

action_t ToMessage(const RecognisedAction& action, int64_t index) {
  action_t message{};
  message.header.utime = action.place_utime;
  message.index = index;
  message.kind = static_cast<int8_t>(action.reading);
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

}  // namespace

Recognizer::Recognizer(Bus& bus, const Params& params)
    : bus_(bus), params_(params) {
  Begin();
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<key_frame_t>(
      "KEY_FRAME", [this](const key_frame_t& m) { return OnKeyFrame(m); });
}

void Recognizer::Begin() {
  recognition_ = std::make_unique<Recognition>(params_.cast, params_.parts,
                                               params_.gallery, params_.sensor,
                                               params_.recognition);
  last_key_frame_ = -1;
  next_index_ = 0;
}

bool Recognizer::OnEpisode(const episode_t& message) {
  if (message.phase == episode_t::START) {
    Begin();
    start_utime_ = message.header.utime;
  }
  return message.phase >= episode_t::START &&
         message.phase <= episode_t::RUNNING;
}

bool Recognizer::OnKeyFrame(const key_frame_t& message) {
  const auto frame = KeyFrameFromMessage(message, params_.cast);
  if (!frame || frame->index <= last_key_frame_) return false;
  if (frame->utime < start_utime_) return true;  // of the episode before
  last_key_frame_ = frame->index;
  for (const RecognisedAction& action : recognition_->Update(*frame)) {
    bus_.Publish("ACTION", ToMessage(action, next_index_++));
  }
  return true;
}

std::unique_ptr<Service> MakeRecognizer(Bus& bus,
                                        const Deployment& deployment) {
  const PartTable parts =
      PartTable::FromConfig(deployment.OfTask("parts.yaml"));
  const CellLayout layout =
      CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  const Config domain_config = deployment.OfTask("domain.yaml");
  const Domain domain = Domain::FromConfig(domain_config, parts);
  Recognizer::Params params{
      Cast(parts, layout),
      parts,
      std::make_shared<const Gallery>(domain, parts),
      std::make_shared<const PredicateSensor>(domain.vocabulary(), parts,
                                              layout.workspace, domain_config),
      {}};
  domain_config.Finish();
  const Config config = deployment.ForService("recognizer");
  params.recognition.moved = config.Number("moved_mm", 0, 1000) * 1e-3;
  params.recognition.turned =
      config.Number("turned_deg", 0, 180) * std::numbers::pi / 180;
  config.Finish();
  return std::make_unique<Recognizer>(bus, params);
}

}  // namespace cell::recognizer
