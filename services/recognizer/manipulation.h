#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/sec/gallery.h"

namespace cell::recognizer {

/// What an action is read as: done, undone, or none that is known.
enum class Reading : int8_t { kForward = 0, kReversed = 1, kUnknown = 2 };

/// A part in somebody's hands, from the pick-up on, with every action and role
/// binding that the key frames so far may turn out to be.
class Manipulation {
 public:
  struct Hypothesis {
    const GalleryEntry* entry;
    Binding binding;
    Reading reading;  // forward or reversed
  };

  /// `before` is the key frame before the pick-up: the hand has not moved
  /// anything yet. @pre not null; `gallery` outlives this object.
  Manipulation(const Gallery& gallery, std::string part, int64_t pick_index,
               int64_t pick_utime, std::shared_ptr<const SensedFrame> before);

  void AddHand(const std::string& hand) { hands_.insert(hand); }

  /// The hypotheses that the key frame of the placement completes; those
  /// reversed come first: what was undone came before what was done.
  std::vector<Hypothesis> CompletedBy(const SensedFrame& after) const;

  const std::string& part() const { return part_; }
  const std::set<std::string>& hands() const { return hands_; }
  int64_t pick_index() const { return pick_index_; }
  int64_t pick_utime() const { return pick_utime_; }
  const SensedFrame& before() const { return *before_; }
  /// Not yet contradicted.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }

 private:
  const Gallery* gallery_;
  std::string part_;
  int64_t pick_index_;
  int64_t pick_utime_;
  std::shared_ptr<const SensedFrame> before_;
  std::set<std::string> hands_;
  std::vector<Hypothesis> hypotheses_;
};

}  // namespace cell::recognizer
