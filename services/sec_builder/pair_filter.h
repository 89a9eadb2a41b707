#pragma once

#include <cstdint>
#include <optional>

#include "common/scene/relation.h"
#include "services/sec_builder/proximity.h"

namespace cell::sec_builder {

/// Decides the relation of one pair from its proximity: two thresholds, and a
/// change must last for some frames. It is dated back to the first of them.
class PairFilter {
 public:
  struct Params {
    double touch = 0.004;    ///< [m] nearer: touching
    double release = 0.010;  ///< [m] further: no longer touching
    /// [m] What is inside by slack >= 0 overlaps until it sticks out by this.
    double stick_out = 0.006;
    int confirm_frames = 2;  ///< a change seen in fewer is flicker
    /// [us] A release is dated back to the first frame beyond `touch`, if that
    /// was not longer before the first one beyond `release`; 0: never.
    int64_t backdate_us = 0;
  };
  struct Change {
    int64_t onset = 0;  ///< [us] first frame that showed it
    Relation relation = Relation::kAbsent;
  };

  explicit PairFilter(const Params& params) : params_(params) {}

  /// Takes the relation that the proximity shows, at once.
  void Start(const Proximity& proximity) { relation_ = Shown(proximity); }

  /// Takes the proximity at `utime`; returns the change that it confirms, if
  /// any.
  std::optional<Change> Update(int64_t utime, const Proximity& proximity);
  /// The pair cannot be measured now: its relation stays the same.
  void Hide();
  /// One of the pair is gone.
  std::optional<Change> Lose(int64_t utime);

  Relation relation() const { return relation_; }
  /// Begin of a change that is not yet confirmed at `utime`, or of a release
  /// that may still be confirmed and dated back.
  std::optional<int64_t> pending_since(int64_t utime) const;

 private:
  Relation Shown(const Proximity& proximity) const;
  int64_t OnsetOf(int64_t utime, Relation shown) const;

  Params params_;
  Relation relation_ = Relation::kAbsent;
  std::optional<Change> candidate_;
  std::optional<int64_t> apart_since_;  // in touch, and beyond `touch`
  int num_seen_ = 0;  // frames in a row that showed the candidate
};

}  // namespace cell::sec_builder
