#include "services/sec_builder/pair_filter.h"

#include <utility>

namespace cell::sec_builder {

Relation PairFilter::Shown(const Proximity& proximity) const {
  const bool was_inside = relation_ == Relation::kOverlapping;
  const bool was_near = was_inside || relation_ == Relation::kTouching;
  const bool is_near = proximity.distance < params_.touch ||
                       (was_near && proximity.distance <= params_.release);
  if (!is_near) return Relation::kNotTouching;
  const double least_slack = was_inside ? -params_.stick_out : 0;
  return proximity.slack >= least_slack ? Relation::kOverlapping
                                        : Relation::kTouching;
}

std::optional<PairFilter::Change> PairFilter::See(int64_t utime,
                                                  const Proximity& proximity) {
  const Relation shown = Shown(proximity);
  if (shown == relation_) {
    candidate_.reset();
    return std::nullopt;
  }
  if (!candidate_ || candidate_->relation != shown) {
    candidate_ = Change{utime, shown};
    num_seen_ = 0;
  }
  if (++num_seen_ < params_.confirm_frames) return std::nullopt;
  relation_ = shown;
  return std::exchange(candidate_, std::nullopt);
}

std::optional<PairFilter::Change> PairFilter::Lose(int64_t utime) {
  candidate_.reset();
  if (relation_ == Relation::kAbsent) return std::nullopt;
  relation_ = Relation::kAbsent;
  return Change{utime, relation_};
}

std::optional<int64_t> PairFilter::pending_since() const {
  if (!candidate_) return std::nullopt;
  return candidate_->onset;
}

}  // namespace cell::sec_builder
