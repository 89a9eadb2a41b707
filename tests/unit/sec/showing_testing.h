#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/sec/learned_library.h"
#include "common/sec/sec_learner.h"
#include "services/recognizer/recognition.h"
#include "tests/unit/stage_testing.h"

namespace cell {

/// Shows manipulations of the shipped task to an observer without a library.
class Demonstration {
 public:
  explicit Demonstration(recognizer::Recognition::Observer observer,
                         const PoseUncertainty& uncertainty = {})
      : words_(std::make_shared<const SceneWords>(
            SceneWords{task_.domain.vocabulary(), task_.parts})),
        stage_(task_),
        recognition_(task_.scene_objects, task_.parts,
                     std::make_shared<const LearnedLibrary>(
                         std::vector<LearnedLibrary::Entry>{}, words_),
                     task_.MakeSensor(uncertainty), {}) {
    recognition_.SetObserver(std::move(observer));
  }

  Stage& stage() { return stage_; }
  const ShippedTask& task() const { return task_; }
  std::shared_ptr<const SceneWords> words() const { return words_; }

  template <class Move>
  void Manipulate(const std::string& part, Move move) {
    stage_.Manipulate(part, move, [this](const KeyFrame& frame) {
      recognition_.Update(frame);
    });
  }
  void Seat(const std::string& part, const std::string& site) {
    Manipulate(part, [&] { stage_.Seat(part, site); });
  }
  void Stand(const std::string& part, double x, double y) {
    Manipulate(part, [&] { stage_.StandAt(part, x, y); });
  }
  void Lay(const std::string& part, double x, double y) {
    Manipulate(part, [&] { stage_.LieAt(part, x, y); });
  }

 private:
  const ShippedTask task_;
  std::shared_ptr<const SceneWords> words_;
  Stage stage_;
  recognizer::Recognition recognition_;
};

}  // namespace cell
