#include "services/cell/scoring/alarm_score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "common/bus/bus.h"

namespace cell::cli {
namespace {

// An action is recognised with the time of a key frame near its end.
constexpr int64_t kSameActionUs = 1'500'000;
constexpr int kInTime = 1;  // [key frames] after the one that shows the action

enum class Due { kNothing, kWarning, kError };

Due WhatIsDue(std::optional<int> before, std::optional<int> after) {
  if (!after) return Due::kError;
  return before && *after > *before ? Due::kWarning : Due::kNothing;
}

bool IsAlarm(const alert_t& alert) {
  return alert.cause == alert_t::LONGER_PLAN || alert.cause == alert_t::NO_PLAN;
}

std::string Describe(const truth_action_t& truth) {
  return fmt::format("{} at {:.2f} s", truth.part,
                     1e-6 * static_cast<double>(truth.header.utime));
}

/// Gives each alarm to the action that it is about.
class AlarmScorer {
 public:
  explicit AlarmScorer(const EpisodeRecord& record) : record_(record) {}

  void Score(const truth_action_t& truth, Due due) {
    ++score_.num_actions;
    score_.num_warnings_due += due == Due::kWarning;
    score_.num_errors_due += due == Due::kError;
    const recognised_action_t* action = TakeAction(truth);
    const alert_t* alarm =
        action != nullptr ? TakeAlarm(action->header.utime) : nullptr;
    if (due == Due::kNothing) {
      if (alarm != nullptr) AddFalse(*alarm);
    } else if (alarm == nullptr) {
      ++score_.num_missed;
      Remark("missed", Describe(truth));
    } else {
      ScoreAlarm(truth, *action, *alarm, due);
    }
  }

  AlarmScore Finish() {
    for (const alert_t& alert : record_.alerts) {
      if (IsAlarm(alert) && !taken_alarms_.contains(&alert)) AddFalse(alert);
    }
    return score_;
  }

 private:
  const recognised_action_t* TakeAction(const truth_action_t& truth) {
    const recognised_action_t* nearest = nullptr;
    const auto distance = [&](const recognised_action_t& action) {
      return std::llabs(action.header.utime - truth.header.utime);
    };
    for (const recognised_action_t& action : record_.actions) {
      if (action.part != truth.part || taken_actions_.contains(&action) ||
          distance(action) > kSameActionUs) {
        continue;
      }
      if (nearest == nullptr || distance(action) < distance(*nearest)) {
        nearest = &action;
      }
    }
    if (nearest != nullptr) taken_actions_.insert(nearest);
    return nearest;
  }

  const alert_t* TakeAlarm(int64_t utime) {
    for (const alert_t& alert : record_.alerts) {
      if (IsAlarm(alert) && alert.header.utime == utime &&
          taken_alarms_.insert(&alert).second) {
        return &alert;
      }
    }
    return nullptr;
  }

  void ScoreAlarm(const truth_action_t& truth,
                  const recognised_action_t& action, const alert_t& alarm,
                  Due due) {
    const int key_frames = KeyFramesUntil(alarm, action.place_key_frame);
    const double seconds =
        1e-6 *
        static_cast<double>(alarm.header.tick * kTickUs - truth.header.utime);
    score_.most_key_frames = std::max(score_.most_key_frames, key_frames);
    score_.most_seconds = std::max(score_.most_seconds, seconds);
    const bool is_error = alarm.level == alert_t::ERROR;
    if (is_error != (due == Due::kError)) {
      ++score_.num_of_wrong_level;
      Remark(is_error ? "an error instead of a warning"
                      : "a warning instead of an error",
             alarm.text);
    } else if (key_frames > kInTime) {
      ++score_.num_late;
      Remark(fmt::format("{} key frames late", key_frames), alarm.text);
    } else {
      ++(is_error ? score_.num_called_errors : score_.num_warned);
    }
  }

  /// Key frames after that one, until the alarm is published.
  int KeyFramesUntil(const alert_t& alarm, int64_t place_key_frame) const {
    int num = 0;
    for (const auto& [index, tick] : record_.key_frame_ticks) {
      num += index > place_key_frame && tick <= alarm.header.tick;
    }
    return num;
  }

  void AddFalse(const alert_t& alarm) {
    ++score_.num_false;
    Remark("false", alarm.text);
  }

  void Remark(const std::string& what, const std::string& about) {
    score_.remarks.push_back(what + ": " + about);
  }

  const EpisodeRecord& record_;
  std::set<const recognised_action_t*> taken_actions_;
  std::set<const alert_t*> taken_alarms_;
  AlarmScore score_;
};

}  // namespace

AlarmScore ScoreAlarms(const EpisodeRecord& record, TrueProgress progress) {
  AlarmScorer scorer(record);
  std::optional<int> before = progress.NumLeft();
  for (const truth_action_t& truth : record.truth_actions) {
    progress.Update(truth);
    const std::optional<int> after = progress.NumLeft();
    scorer.Score(truth, WhatIsDue(before, after));
    before = after;
  }
  return scorer.Finish();
}

}  // namespace cell::cli
