#include "services/cell/scoring/assembly_observer.h"

#include <algorithm>
#include <utility>

#include "cell/alert_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/truth_action_t.hpp"
#include "common/bus/decode.h"
#include "services/cell/scoring/episode_observer.h"

namespace cell::cli {

void AssemblyObserver::Put(const Message& message) {
  if (message.channel == "SKILL_REQUEST") {
    const auto request = Decode<asked_skill_t>(message);
    if (!request) return;
    ++record_.num_requests;
    if (request->skill == "insert") inserts_.insert(request->id);
  } else if (message.channel == "SKILL_RESULT") {
    OnResult(message);
  } else if (message.channel == "EXECUTION") {
    if (auto execution = Decode<execution_t>(message)) {
      record_.execution = *std::move(execution);
    }
  } else if (message.channel == "ALERT") {
    const auto alert = Decode<alert_t>(message);
    if (alert && alert->cause == alert_t::UNATTENDED) {
      record_.unattended = alert->text;
    }
  } else if (message.channel == "TRUTH_ACTIONS") {
    if (const auto action = Decode<truth_action_t>(message)) {
      record_.touched.insert(action->part);
    }
  } else if (message.channel == "TRUTH_POSES") {
    if (auto poses = Decode<truth_poses_t>(message)) {
      OnPoses(*std::move(poses));
    }
  }
}

void AssemblyObserver::OnResult(const Message& message) {
  const auto result = Decode<skill_result_t>(message);
  if (!result) return;
  record_.num_refused += result->outcome == skill_result_t::REFUSED;
  record_.num_failed += result->outcome == skill_result_t::FAILED;
  record_.num_stopped += result->outcome == skill_result_t::STOPPED;
  record_.num_yielded += result->outcome == skill_result_t::YIELDED;
  record_.peak_force = std::max(record_.peak_force, result->peak_force);
  is_to_compare_ |= result->outcome == skill_result_t::SUCCEEDED &&
                    inserts_.contains(result->id);
}

void AssemblyObserver::OnPoses(truth_poses_t poses) {
  record_.last_utime = poses.header.utime;
  looks_.Put(std::move(poses));
  if (std::exchange(is_to_compare_, false)) CompareWithEarlier();
}

void AssemblyObserver::CompareWithEarlier() {
  const auto score = Score();
  if (!score) return;
  const std::set<std::string> now(score->seated.begin(), score->seated.end());
  std::ranges::set_difference(seated_, now, std::back_inserter(record_.broken));
  seated_ = now;
}

std::optional<AssemblyScore> AssemblyObserver::Score() const {
  if (!looks_.has_both()) return std::nullopt;
  return ScoreAssembly(looks_.earlier(), looks_.last(), success_);
}

}  // namespace cell::cli
