#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cell/execution_t.hpp"
#include "common/bus/message.h"
#include "services/cell/scoring/assembly_score.h"
#include "services/cell/scoring/pose_history.h"

namespace cell::cli {

/// Scores a cell that assembles by itself. Reads ground truth, so no service
/// may use it.
class AssemblyObserver {
 public:
  struct Record {
    std::optional<execution_t> execution;  ///< the last
    std::string unattended;                ///< why the run has ended early
    int num_requests = 0;                  ///< of skills
    int num_refused = 0, num_failed = 0, num_stopped = 0, num_yielded = 0;
    double peak_force = 0;  ///< [N] of all skills
    /// Sites with a part that was seated, and no longer was after a later step;
    /// one entry for each time.
    std::vector<std::string> broken;
    std::set<std::string> touched;  ///< parts that a person put somewhere
    int64_t last_utime = 0;
  };

  /// `success` must outlive this object.
  explicit AssemblyObserver(const SuccessCriterion& success)
      : success_(success) {}

  /// Messages in canonical order. Those that do not decode are passed over.
  void Put(const Message& message);
  const Record& record() const { return record_; }
  /// By the last poses. Nothing before there have been enough.
  std::optional<AssemblyScore> Score() const;

 private:
  void OnResult(const Message& message);
  void OnPoses(truth_poses_t poses);
  void CompareWithEarlier();

  const SuccessCriterion& success_;
  Record record_;
  std::set<int64_t> inserts_;  // ids of requests
  PoseHistory looks_;
  bool is_to_compare_ = false;    // with the next look
  std::set<std::string> seated_;  // sites, as of the last comparison
};

}  // namespace cell::cli
