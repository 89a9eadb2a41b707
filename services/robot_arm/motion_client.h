#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/arms/motion_request.h"

namespace cell::robot_arm {

/// What an arm asks of the planner of motions, and the answers. Pure.
class MotionClient {
 public:
  MotionClient() = default;
  MotionClient(const MotionClient&) = delete;
  MotionClient& operator=(const MotionClient&) = delete;

  /// The id that the answer will carry.
  int64_t Ask(MotionRequest request);
  /// The answer is no longer wanted.
  void Forget(int64_t id) { open_.erase(id); }
  /// The same request once more, if there is no answer yet: it was lost.
  void Repeat(int64_t id);
  /// False if its request is not open.
  bool Put(const MotionPlan& plan);
  /// nullptr if there is no answer yet, or no such request.
  const MotionPlan* Find(int64_t id) const;

  /// What has been asked since the last call.
  std::vector<MotionRequest> TakeRequests();

 private:
  struct Open {
    MotionRequest request;
    std::optional<MotionPlan> plan;
  };
  int64_t next_id_ = 1;
  std::map<int64_t, Open> open_;  ///< by id
  std::vector<MotionRequest> asked_;
};

/// A request that is waited for; gone with this object.
class MotionInquiry {
 public:
  enum class State { kWaiting, kFound, kNone };

  /// Asks at once. `client` must outlive this object.
  MotionInquiry(MotionClient& client, const MotionRequest& request);
  MotionInquiry(const MotionInquiry&) = delete;
  MotionInquiry& operator=(const MotionInquiry&) = delete;
  ~MotionInquiry() { client_.Forget(id_); }

  /// `dt` [s] have passed. Asks again now and then, and gives up at last.
  State Step(double dt);
  /// @pre Step() has returned kFound.
  const MotionPlan& plan() const { return *client_.Find(id_); }
  /// Why there is none, after kNone.
  std::string reason() const;
  /// False if it has given up.
  bool is_answered() const { return client_.Find(id_) != nullptr; }

 private:
  MotionClient& client_;
  int64_t id_;
  double waited_ = 0;  // [s]
  double asked_ = 0;   // of it, when it has last asked
};

}  // namespace cell::robot_arm
