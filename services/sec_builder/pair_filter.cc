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

std::optional<PairFilter::Change> PairFilter::Update(
    int64_t utime, const Proximity& proximity) {
  const Relation shown = Shown(proximity);
  const bool is_near = proximity.distance < params_.touch;
  if (is_near || relation_ == Relation::kNotTouching) {
    apart_since_.reset();
  } else if (!apart_since_) {
    apart_since_ = utime;
  }
  if (shown == relation_) {
    candidate_.reset();
    return std::nullopt;
  }
  if (!candidate_ || candidate_->relation != shown) {
    candidate_ = Change{OnsetOf(utime, shown), shown};
    num_seen_ = 0;
  }
  if (++num_seen_ < params_.confirm_frames) return std::nullopt;
  relation_ = shown;
  return std::exchange(candidate_, std::nullopt);
}

std::optional<PairFilter::Change> PairFilter::Lose(int64_t utime) {
  Hide();
  if (relation_ == Relation::kAbsent) return std::nullopt;
  relation_ = Relation::kAbsent;
  return Change{utime, relation_};
}

void PairFilter::Hide() {
  candidate_.reset();
  apart_since_.reset();
}

int64_t PairFilter::OnsetOf(int64_t utime, Relation shown) const {
  const bool is_backdated = shown == Relation::kNotTouching && apart_since_ &&
                            utime - *apart_since_ <= params_.backdate_us;
  return is_backdated ? *apart_since_ : utime;
}

std::optional<int64_t> PairFilter::pending_since(int64_t utime) const {
  if (candidate_) return candidate_->onset;
  if (!apart_since_ || utime - *apart_since_ >= params_.backdate_us) {
    return std::nullopt;
  }
  return apart_since_;
}

}  // namespace cell::sec_builder
