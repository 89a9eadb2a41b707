#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/config/deployment.h"
#include "common/recordings/recording.h"
#include "common/sec/learned_model.h"
#include "common/sec/sec_learner.h"
#include "common/task/task.h"

namespace cell::cli {

/// Learns how the actions of a task show from recorded demonstrations: tracks
/// and key frames are computed from them as in a cell that runs.
class SecLessons {
 public:
  /// @throws ConfigError for a task or configuration that cannot be used.
  explicit SecLessons(const Deployment& deployment);

  /// @throws RecordingError for a recording of another task, and for a name
  /// that refers to nothing or cannot be given.
  void Attend(const Recording& recording);

  /// The same, but each name is learned from its first showing alone, and what
  /// nobody names is passed over. @throws like Attend().
  void AttendFirstShowings(const Recording& recording);

  /// All groups of showings; the unnamed ones have made-up names.
  std::vector<SecLearner::Action> Actions() const { return learner_.Actions(); }
  /// The models of the actions of the task, with their arguments.
  /// @throws RecordingError for a name that is no action's of the task, and for
  /// roles that are not its arguments.
  std::map<std::string, LearnedModel> Models() const;
  /// The file sec_models.yaml of these models. @throws like Models().
  std::string ModelsText() const;

 private:
  void RequireTask(const Recording& recording) const;

  Deployment deployment_;
  Task task_;
  SecLearner learner_;
  std::set<std::string> names_;  // with a first showing
};

}  // namespace cell::cli
