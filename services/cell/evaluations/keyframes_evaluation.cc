#include "services/cell/evaluations/keyframes_evaluation.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <utility>

#include "common/recordings/noisy_tracks.h"
#include "common/task/task.h"
#include "services/cell/evaluations/pose_noise.h"
#include "services/cell/recordings/recorded_tracks.h"
#include "services/cell/recordings/simulated_recording.h"
#include "services/cell/scoring/contact_score.h"
#include "services/sec_builder/key_frame_builder.h"

namespace cell::cli {

using namespace sec_builder;
namespace {

using nlohmann::json;

// Scripts of the task's demonstrators.yaml, taken in turn.
constexpr std::array<const char*, 4> kShownScripts = {
    "assembly", "assembly_two_hands", "take_backs", "unknown_moves"};
constexpr double kMillimetre = 1e-3;

/// A level of noise, and what is aimed at there.
struct Level {
  const char* name;
  double mm = 0;                // standard deviation of each coordinate
  bool is_interrupted = false;  // tracks drop out, and names are swapped
  double goal_f1 = 0;
  double goal_exact = 0;
};
constexpr std::array<Level, 7> kLevels = {
    {{"no noise", 0, false, 0, 0},
     {"1 mm", 1, false, 0, 0},
     {"2 mm", 2, false, 0.98, 0.90},
     {"3 mm", 3, false, 0, 0},
     {"4 mm", 4, false, 0.90, 0},
     {"5 mm", 5, false, 0, 0},
     {"2 mm, dropouts and swaps", 2, true, 0, 0}}};

NoisyTracks::Params NoiseOf(const Level& level, const PartTable& parts,
                            uint64_t seed) {
  NoisyTracks::Params noise = PoseNoise(level.mm, seed);
  if (!level.is_interrupted) return noise;
  noise.dropout_probability = 0.005;
  noise.swap_probability = 0.002;
  const auto& all = parts.parts();
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t j = i + 1; j < all.size(); ++j) {
      if (all[i].type != all[j].type) continue;
      noise.alike.emplace_back(all[i].name, all[j].name);
    }
  }
  return noise;
}

json ToJson(const ContactScore& score) {
  return {{"true", score.num_true},       {"found", score.num_found},
          {"matched", score.num_matched}, {"actions", score.num_actions},
          {"exact", score.num_exact},     {"same", score.num_same_columns}};
}

ContactScore FromJson(const json& row) {
  return {row.at("true"),    row.at("found"), row.at("matched"),
          row.at("actions"), row.at("exact"), row.at("same")};
}

ContactScore TotalOf(const std::vector<json>& rows, const Level& level) {
  ContactScore total;
  for (const json& row : rows) total += FromJson(row.at(level.name));
  return total;
}

class KeyframesEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "keyframes"; }
  std::string description() const override {
    return "Compare key frames with contact truth, at pose noise of 0 to 5 mm.";
  }
  int default_runs() const override { return 24; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const Task task = LoadTask(deployment);
    const char* script = kShownScripts[trial.seed % kShownScripts.size()];
    const Recording recording =
        SimulatedRecording(deployment, roster, script, trial.seed, "");
    const auto params = KeyFrameBuilder::Params::Load(deployment, task);
    const auto true_tracks = [&] {
      return std::make_unique<RecordedTracks>(recording, task.scene_objects,
                                              task.layout,
                                              tracker::IdealTracker::Params{});
    };
    const auto truth =
        TrueContactEvents(*true_tracks(), task.scene_objects, task.parts,
                          params.extractor.pair.touch);
    json row = {{"script", script}};
    for (const Level& level : kLevels) {
      NoisyTracks tracks(true_tracks(), NoiseOf(level, task.parts, trial.seed));
      row[level.name] = ToJson(ScoreContacts(
          truth, EventsIn(tracks, level, params), task.scene_objects,
          {.merge_us = params.extractor.merge_us}));
    }
    return row;
  }

  RowShape row_shape() const override {
    const RowShape score = RowShape::Counts(
        {"true", "found", "matched", "actions", "exact", "same"});
    RowShape::Fields fields;
    for (const Level& level : kLevels) fields.emplace(level.name, score);
    return RowShape::Record(fields);
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures;
    for (const Level& level : kLevels) {
      const ContactScore s = TotalOf(rows, level);
      const auto add = [&](const char* what, int good, int all, double goal) {
        measures.push_back({fmt::format("{}: {}", level.name, what), good, all,
                            std::nullopt, goal});
      };
      add("event precision", s.num_matched, s.num_found, 0);
      add("event recall", s.num_matched, s.num_true, 0);
      add("event F1 at 0.3 s", 2 * s.num_matched, s.num_true + s.num_found,
          level.goal_f1);
      add("actions with the exact chain", s.num_exact, s.num_actions,
          level.goal_exact);
      add("actions with the same columns, too", s.num_same_columns,
          s.num_actions, 0);
    }
    return measures;
  }

 private:
  /// The estimator knows how noisy its tracks are, as pose_noise_mm says.
  static std::vector<ContactEvent> EventsIn(TrackStream& tracks,
                                            const Level& level,
                                            KeyFrameBuilder::Params params) {
    params.smoother.position_sd = level.mm * kMillimetre;
    KeyFrameBuilder builder(params);
    std::vector<KeyFrame> frames;
    while (const auto now = tracks.Next()) {
      std::ranges::move(builder.Update(*now), std::back_inserter(frames));
    }
    return ContactEventsOf(frames, params.scene_objects);
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeKeyframesEvaluation() {
  return std::make_unique<KeyframesEvaluation>();
}

}  // namespace cell::cli
