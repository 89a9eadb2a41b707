#include "services/tracker/tracker.h"

#include <string>
#include <utility>

#include "common/parts/part_table.h"
#include "common/task/task.h"

namespace cell::tracker {

Tracker::Tracker(Bus& bus, const Params& params)
    : bus_(bus),
      scene_objects_(params.scene_objects),
      tracker_(params.scene_objects, params.layout, params.ideal) {
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<truth_poses_t>(
      "TRUTH_POSES", [this](const truth_poses_t& m) { return OnTruth(m); }, 1);
  bus.Every(params.period_ticks, 0, [this] { PublishTracks(); });
}

bool Tracker::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) truth_.reset();
  return event.has_value();
}

bool Tracker::OnTruth(const truth_poses_t& message) {
  auto truth = TruthFromMessage(message);
  if (!truth) return false;
  truth_ = *std::move(truth);
  return true;
}

void Tracker::PublishTracks() {
  if (!truth_) return;
  bus_.Publish("TRACKS",
               TracksToMessage(tracker_.Update(*truth_), scene_objects_));
  truth_.reset();
}

std::unique_ptr<Service> MakeTracker(Bus& bus, const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  Tracker::Params params{task.scene_objects, task.layout, 12, {}};
  const Config config = deployment.ForService("tracker");
  const auto sensing = config.Get<std::string>("sensing");
  if (sensing != "ideal") {
    config["sensing"].Fail("only 'ideal' is supported, not '" + sensing + "'");
  }
  params.period_ticks = config.Integer("period_ticks", 1, 1250);
  params.ideal.hand_spacing = config.Number("hand_spacing_mm", 1, 100) * 1e-3;
  config.Finish();
  return std::make_unique<Tracker>(bus, params);
}

}  // namespace cell::tracker
