#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "cell/motion_request_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/input_alerts.h"
#include "common/config/deployment.h"
#include "services/motion_planner/motion_search.h"

namespace cell::motion_planner {

/// MOTION_REQUEST -> MOTION_PLAN. Keeps nothing: an answer is a function of its
/// request. May take longer than a tick (its latency) without delaying an arm's
/// tick. Of the requests within that time it answers the newest way and the
/// newest reach of each arm: the arm no longer waits for older ones.
class MotionPlanner final : public Service {
 public:
  /// `bus` must outlive this object.
  MotionPlanner(Bus& bus, MotionSearch::Params params);

 private:
  bool OnRequest(const motion_request_t& message);
  void Answer();

  struct Waiting {
    int64_t utime = 0;
    MotionRequest request;
  };
  Bus& bus_;
  InputAlerts alerts_;
  MotionSearch search_;
  std::map<std::pair<std::string, bool>, Waiting> waiting_;  ///< arm, is reach
};

std::unique_ptr<Service> MakeMotionPlanner(Bus& bus,
                                           const Deployment& deployment);

}  // namespace cell::motion_planner
