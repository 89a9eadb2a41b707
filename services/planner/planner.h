#pragma once

#include <memory>
#include <optional>

#include "cell/action_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/predicates_t.hpp"
#include "common/bus/bus.h"
#include "common/config/deployment.h"
#include "common/relational/domain.h"
#include "services/planner/monitor.h"

namespace cell {

/// The decision maker (section VII-B): PREDICATES and ACTION -> PLAN, ALERT,
/// for the goal that EPISODE names.
class Planner final : public Service {
 public:
  struct Params {
    Domain domain;
    PlanSearch::Params search;
    Monitor::Params monitor;
  };

  /// `bus` must outlive this object.
  Planner(Bus& bus, Params params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnPredicates(const predicates_t& message);
  bool OnAction(const action_t& message);
  void Publish(const Monitor::Report& report);

  Bus& bus_;
  Params params_;
  std::optional<Monitor> monitor_;  // of the episode
  int64_t start_utime_ = 0;         // of the episode
};

std::unique_ptr<Service> MakePlanner(Bus& bus, const Deployment& deployment);

}  // namespace cell
