#include "services/cell/learning/sec_lessons.h"

#include <fmt/format.h>

#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "common/actions/sec_models.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/learned_library.h"
#include "common/text/printable.h"
#include "services/cell/recordings/recorded_tracks.h"
#include "services/recognizer/recognition.h"
#include "services/sec_builder/key_frame_builder.h"

namespace cell::cli {
namespace {

constexpr char kHead[] =
    "# How the task's actions show in event chains. Learned by `cell learn "
    "sec`\n"
    "# from the demonstrations in recordings/.\n";

/// One recording, and what is learned from it.
class Lesson {
 public:
  /// @param names  unless null: each name that is not in it is learned from one
  /// showing alone, and added to it
  Lesson(const Recording& recording, const Deployment& deployment,
         const Task& task, SecLearner& learner, std::set<std::string>* names)
      : recording_(recording),
        source_(fmt::format("{} {}", recording.demonstration, recording.seed)),
        learner_(learner),
        names_(names),
        tracks_(recording, task.scene_objects, task.layout, {}),
        builder_(sec_builder::KeyFrameBuilder::Params::Load(deployment, task)),
        recognition_(task.scene_objects, task.parts,
                     std::make_shared<const LearnedLibrary>(
                         std::vector<LearnedLibrary::Entry>{},
                         std::make_shared<const SceneWords>(
                             SceneWords{task.domain.vocabulary(), task.parts})),
                     task.MakeSensor(), {}) {
    recognition_.SetObserver([this](const auto& manipulation, const auto&) {
      if (names_ == nullptr) {
        last_ = learner_.Add(manipulation, source_, recording_.build);
      } else {
        shown_.emplace(Shown{manipulation.part, manipulation.before,
                             manipulation.after, manipulation.chain});
      }
    });
  }

  void Attend() {
    while (const auto tracks = tracks_.Next()) {
      seen_.push_back(tracks->utime);
      if (seen_.size() > builder_.lag_frames()) {
        Listen(seen_.front());
        seen_.pop_front();
      }
      for (const KeyFrame& frame : builder_.Update(*tracks)) {
        recognition_.Update(frame);
      }
    }
    Listen(std::numeric_limits<int64_t>::max());
  }

 private:
  /// A manipulation that is not learned yet.
  struct Shown {
    std::string part;
    SensedFrame before, after;
    EventChain chain;
  };

  /// Names spoken before `utime` refer to manipulations before it.
  void Listen(int64_t utime) {
    for (; num_heard_ < recording_.spoken.size(); ++num_heard_) {
      const Recording::SpokenName& said = recording_.spoken[num_heard_];
      if (said.utime >= utime) return;
      if (names_ != nullptr) {
        if (!names_->insert(said.name).second) continue;
        LearnShown();
      }
      if (!last_) Fail(said, "nothing was shown before it");
      const auto group = learner_.Name(*last_, said.name, said.is_undone);
      if (!group) Fail(said, group.reason());
      last_ = SecLearner::Lesson{*group,
                                 said.is_undone ? ActionDirection::kReversed
                                                : ActionDirection::kForward,
                                 false};
    }
  }

  void LearnShown() {
    last_.reset();
    if (!shown_) return;
    last_ = learner_.Add(
        {shown_->part, shown_->before, shown_->after, shown_->chain}, source_,
        recording_.build);
  }

  [[noreturn]] void Fail(const Recording::SpokenName& said,
                         const std::string& why) const {
    throw RecordingError(fmt::format("{}: '{}' is said at {} us, but {}",
                                     source_, Printable(said.name), said.utime,
                                     why));
  }

  const Recording& recording_;
  std::string source_;
  SecLearner& learner_;
  std::set<std::string>* names_;
  std::optional<Shown> shown_;
  RecordedTracks tracks_;
  sec_builder::KeyFrameBuilder builder_;
  std::deque<int64_t> seen_;  // times of the tracks not listened to yet
  recognizer::Recognition recognition_;
  std::optional<SecLearner::Lesson> last_;
  size_t num_heard_ = 0;
};

}  // namespace

SecLessons::SecLessons(const Deployment& deployment)
    : deployment_(deployment),
      task_(LoadTask(deployment)),
      learner_(std::make_shared<const SceneWords>(
                   SceneWords{task_.domain.vocabulary(), task_.parts}),
               MakeChainSimilarity(SecLearner::kMeasure), {}) {}

void SecLessons::Attend(const Recording& recording) {
  RequireTask(recording);
  Lesson(recording, deployment_, task_, learner_, nullptr).Attend();
}

void SecLessons::AttendFirstShowings(const Recording& recording) {
  RequireTask(recording);
  Lesson(recording, deployment_, task_, learner_, &names_).Attend();
}

void SecLessons::RequireTask(const Recording& recording) const {
  const auto task =
      (deployment_.task_dir / "").parent_path().filename().string();
  if (recording.task == task) return;
  throw RecordingError(fmt::format(
      "{} {}: is a recording of the task {}, not {}", recording.demonstration,
      recording.seed, Printable(recording.task), task));
}

std::map<std::string, LearnedModel> SecLessons::Models() const {
  std::map<std::string, LearnedModel> models;
  for (const SecLearner::Action& learned : learner_.Actions()) {
    if (!learned.is_named) continue;
    const auto action = task_.domain.FindAction(learned.name);
    if (!action) {
      throw RecordingError("the task has no action '" +
                           Printable(learned.name) + "'");
    }
    const auto fitted = FitToArguments(
        learned.model,
        task_.domain.actions()[static_cast<size_t>(*action)].arguments,
        task_.domain.vocabulary().types());
    if (!fitted) throw RecordingError(learned.name + ": " + fitted.reason());
    models.emplace(learned.name, *fitted);
  }
  return models;
}

std::string SecLessons::ModelsText() const {
  return kHead + SecModelsText(Models(), task_.domain.vocabulary());
}

}  // namespace cell::cli
