#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/bus/message.h"
#include "common/task/task.h"
#include "services/cell/scoring/assembly_observer.h"
#include "services/cell/scoring/motion_check.h"

namespace cell::cli {

/// What each episode of a run came to in which a cell learns from a person whom
/// it asks. Reads ground truth, so no service may use it.
class TaughtEpisodes {
 public:
  /// Both must outlive this object.
  TaughtEpisodes(const Task& task, const SuccessCriterion& success);

  /// Messages in canonical order. Those that do not decode are passed over.
  void Put(const Message& message);

  /// An object for each episode: that of AssemblyRow(), `questions` (texts) and
  /// `demonstrations` (what the person has placed or taken away).
  nlohmann::json Rows() const;

 private:
  /// An episode, as it was seen from its start to its end.
  struct Episode {
    Episode(const Task& task, const SuccessCriterion& success)
        : assembly(success), check(task.layout, task.parts) {}
    AssemblyObserver assembly;
    MotionCheck check;
    std::vector<std::string> questions;
    int num_demonstrations = 0;
    int64_t start_utime = 0;
    bool has_ended = false;
  };

  void OnEpisode(const Message& message);

  const Task& task_;
  const SuccessCriterion& success_;
  std::vector<std::unique_ptr<Episode>> episodes_;
};

/// True if from this episode on (0: the first) nothing was asked and everything
/// was assembled. @param episodes  of TaughtEpisodes::Rows()
bool IsTaughtFrom(const nlohmann::json& episodes, size_t first);

}  // namespace cell::cli
