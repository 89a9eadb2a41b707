#include "services/cell/scoring/episode_score.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace cell::cli {
namespace {

// A placement is seen within the tracker's period and the SEC's fixed lag of
// the moment the hand let go.
constexpr int64_t kMatchUs = 1'500'000;

// The key frame which shows the action, and one more.
constexpr int64_t kOneKeyFrame = 1;

bool Names(const recognised_action_t& action, const truth_action_t& truth) {
  if (action.part != truth.part ||
      std::llabs(action.header.utime - truth.header.utime) > kMatchUs) {
    return false;
  }
  switch (truth.kind) {
    case truth_action_t::PLACED:
    case truth_action_t::TAKEN_BACK: {
      const int8_t kind = truth.kind == truth_action_t::PLACED
                              ? recognised_action_t::FORWARD
                              : recognised_action_t::REVERSED;
      // An action without a site among its arguments has but one place to go.
      return action.kind == kind && !action.arguments.empty() &&
             action.arguments[0] == truth.part &&
             (action.arguments.size() == 1 ||
              action.arguments[1] == truth.site);
    }
    case truth_action_t::TIPPED:
      // Raising may be an action of the task; laying down is its reverse.
      return action.kind == recognised_action_t::UNKNOWN ||
             action.arguments.size() == 1;
    default:
      return action.kind == recognised_action_t::UNKNOWN;
  }
}

// Matches each true action to one that was recognised.
std::vector<std::optional<size_t>> Match(const EpisodeRecord& record) {
  std::vector<std::optional<size_t>> matches;
  std::vector<bool> is_taken(record.actions.size(), false);
  for (const truth_action_t& truth : record.truth_actions) {
    std::optional<size_t> match;
    for (size_t i = 0; i < record.actions.size() && !match; ++i) {
      if (!is_taken[i] && Names(record.actions[i], truth)) match = i;
    }
    if (match) is_taken[*match] = true;
    matches.push_back(match);
  }
  return matches;
}

// Alerts about the plan that answer this action: from the action until one key
// frame after the one that showed it.
std::vector<const alert_t*> AlertsOf(const EpisodeRecord& record,
                                     const recognised_action_t& action) {
  std::vector<const alert_t*> alerts;
  const int64_t from = action.header.utime;
  const auto after =
      record.key_frame_utimes.find(action.place_key_frame + kOneKeyFrame + 1);
  const int64_t until = after != record.key_frame_utimes.end()
                            ? after->second
                            : record.last_utime;
  for (const alert_t& alert : record.alerts) {
    const bool is_of_plan =
        alert.cause == alert_t::LONGER_PLAN || alert.cause == alert_t::NO_PLAN;
    if (is_of_plan && alert.header.utime >= from &&
        alert.header.utime <= until) {
      alerts.push_back(&alert);
    }
  }
  return alerts;
}

int CountLevel(const std::vector<const alert_t*>& alerts, int8_t level) {
  return static_cast<int>(
      std::count_if(alerts.begin(), alerts.end(),
                    [level](const alert_t* a) { return a->level == level; }));
}

void ScoreMistake(const truth_action_t& truth,
                  const std::vector<const alert_t*>& alerts,
                  EpisodeScore* score) {
  ++score->num_mistakes;
  const int8_t level = truth.mistake == truth_action_t::OUT_OF_ORDER
                           ? alert_t::WARNING
                           : alert_t::ERROR;
  if (CountLevel(alerts, level) > 0) ++score->num_mistakes_caught;
}

}  // namespace

EpisodeScore Score(const EpisodeRecord& record) {
  EpisodeScore score;
  const auto matches = Match(record);
  std::vector<const alert_t*> explained;
  for (size_t i = 0; i < matches.size(); ++i) {
    const truth_action_t& truth = record.truth_actions[i];
    const bool is_named = matches[i].has_value();
    std::vector<const alert_t*> alerts;
    if (is_named) alerts = AlertsOf(record, record.actions[*matches[i]]);
    const bool is_mistake = truth.mistake != truth_action_t::NONE;
    if (is_mistake) ScoreMistake(truth, alerts, &score);
    if (truth.kind == truth_action_t::PLACED) {
      ++score.num_steps;
      score.num_steps_recognised += is_named;
    } else if (truth.kind == truth_action_t::TAKEN_BACK) {
      ++score.num_take_backs;
      score.num_take_backs_named += is_named;
      score.num_take_backs_warned +=
          CountLevel(alerts, alert_t::WARNING) == 1 &&
          CountLevel(alerts, alert_t::ERROR) == 0;
    } else {
      ++score.num_moves;
      score.num_moves_named += is_named;
    }
    if (is_mistake || truth.kind == truth_action_t::TAKEN_BACK) {
      explained.insert(explained.end(), alerts.begin(), alerts.end());
    }
  }
  const auto num_matched = static_cast<int>(
      std::count_if(matches.begin(), matches.end(),
                    [](const auto& match) { return match.has_value(); }));
  score.num_invented = static_cast<int>(record.actions.size()) - num_matched;
  for (const alert_t& alert : record.alerts) {
    const bool is_alarm =
        alert.cause == alert_t::LONGER_PLAN || alert.cause == alert_t::NO_PLAN;
    score.num_false_alarms +=
        is_alarm && std::find(explained.begin(), explained.end(), &alert) ==
                        explained.end();
  }
  score.is_goal_reached = !record.plans.empty() &&
                          record.plans.back().result == plan_t::GOAL_REACHED;
  return score;
}

}  // namespace cell::cli
