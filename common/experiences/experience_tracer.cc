#include "common/experiences/experience_tracer.h"

#include <algorithm>
#include <utility>

namespace cell {

void ExperienceTracer::Sensed(int64_t key_frame, int64_t utime,
                              const State& state) {
  sensings_.push_back({key_frame, utime, state});
}

void ExperienceTracer::Done(const GroundAction& action, int64_t pick_key_frame,
                            int64_t place_key_frame) {
  manipulations_.push_back({action, pick_key_frame, place_key_frame, false});
}

void ExperienceTracer::Reversed(const GroundAction& action,
                                int64_t pick_key_frame,
                                int64_t place_key_frame) {
  manipulations_.push_back({action, pick_key_frame, place_key_frame, true});
}

void ExperienceTracer::Moved(int64_t pick_key_frame, int64_t place_key_frame) {
  manipulations_.push_back(
      {std::nullopt, pick_key_frame, place_key_frame, false});
}

void ExperienceTracer::Failed(const GroundAction& action, int64_t begin_utime,
                              int64_t end_utime) {
  failures_.push_back({action, begin_utime, end_utime, true});
}

void ExperienceTracer::Attempted(const GroundAction& action,
                                 int64_t begin_utime, int64_t end_utime) {
  failures_.push_back({action, begin_utime, end_utime, false});
}

std::vector<rules::Experience> ExperienceTracer::Experiences() const {
  std::vector<Manipulation> ordered = manipulations_;
  std::ranges::stable_sort(ordered, {}, &Manipulation::place);
  std::vector<rules::Experience> experiences;
  for (const Manipulation& manipulation : ordered) {
    if (auto found = Of(manipulation)) experiences.push_back(*found);
  }
  for (const Failure& failure : failures_) {
    if (auto found = Of(failure)) experiences.push_back(*found);
  }
  return experiences;
}

bool ExperienceTracer::IsAlone(const Manipulation& manipulation) const {
  const auto overlapping =
      std::ranges::count_if(manipulations_, [&](const Manipulation& other) {
        return other.pick <= manipulation.place &&
               manipulation.pick <= other.place;
      });
  return overlapping == 1;  // itself
}

std::optional<rules::Experience> ExperienceTracer::Of(
    const Manipulation& manipulation) const {
  if (!manipulation.action || !IsAlone(manipulation)) return std::nullopt;
  const Sensing* before = nullptr;
  const Sensing* after = nullptr;
  for (const Sensing& sensing : sensings_) {
    if (sensing.key_frame < manipulation.pick) before = &sensing;
    if (sensing.key_frame == manipulation.place && after == nullptr) {
      after = &sensing;
    }
  }
  if (before == nullptr || after == nullptr) return std::nullopt;
  if (manipulation.is_reversed) std::swap(before, after);
  return world_.ToExperience(before->state, *manipulation.action, after->state);
}

std::optional<rules::Experience> ExperienceTracer::Of(
    const Failure& failure) const {
  const Sensing* before = nullptr;
  const Sensing* after = nullptr;
  for (const Sensing& sensing : sensings_) {
    if (sensing.utime <= failure.begin_utime) before = &sensing;
    if (!failure.is_sensed_afterwards) {
      if (sensing.utime > failure.begin_utime &&
          sensing.utime <= failure.end_utime) {
        after = &sensing;
      }
    } else if (sensing.utime >= failure.end_utime && after == nullptr) {
      after = &sensing;
    }
  }
  if (before == nullptr || after == nullptr) return std::nullopt;
  if (!failure.is_sensed_afterwards) after = before;
  return world_.ToExperience(before->state, failure.action, after->state);
}

}  // namespace cell
