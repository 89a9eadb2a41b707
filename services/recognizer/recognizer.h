#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/action_record_t.hpp"
#include "cell/command_name_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/store_answer_t.hpp"
#include "common/actions/action_models.h"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "common/scene/scene_objects.h"
#include "services/recognizer/learning.h"
#include "services/recognizer/recognition.h"

namespace cell::recognizer {

/// KEY_FRAME -> ACTION: names manipulations, forward or reversed, and tells
/// unknown ones (section VII-A). ACTION_RECORD replaces what it knows of an
/// action; after a restart during an episode it sends a LIBRARY_REQUEST.
///
/// If it learns, COMMAND_NAME names the manipulation that was reported last,
/// and what was learned goes to the library by STORE_REQUEST.
class Recognizer final : public Service {
 public:
  struct Params {
    /// Makes the library of SEC models of what is known.
    using MakeSecLibrary =
        std::function<std::shared_ptr<const SecLibrary>(const ActionModels&)>;

    SceneObjects scene_objects;
    ActionModels actions;
    MakeSecLibrary make_library;
    std::shared_ptr<const PredicateSensor> sensor;
    Recognition::Params recognition;
    std::optional<GenericSkill> new_skill;  ///< if it learns

    /// Of recognizer.yaml and the task. @throws ConfigError naming file:key.
    static Params Load(const Deployment& deployment);
  };

  /// `bus` must outlive this object.
  Recognizer(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnKeyFrame(const key_frame_t& message);
  bool OnRecord(const action_record_t& message);
  CommandAnswer OnName(const command_name_t& message);
  void OnStored(const store_answer_t& message);
  void Begin();
  void Learn(const ObservedManipulation& manipulation,
             const std::vector<RecognisedAction>& actions);
  void RequestChanges();

  Bus& bus_;
  EpisodeGate episode_;
  Params params_;
  ActionModels actions_;              // updated by ACTION_RECORD
  std::optional<Learning> learning_;  // if it learns
  std::string demonstration_;         // that is shown
  /// What manipulations that end at the key frame have shown, by moved part.
  std::map<std::string, Learning::Shown> shown_;
  std::unique_ptr<Recognition> recognition_;  // of the episode
  int64_t last_key_frame_ = -1;
  int64_t next_index_ = 0;
};

std::unique_ptr<Service> MakeRecognizer(Bus& bus, const Deployment& deployment);

}  // namespace cell::recognizer
