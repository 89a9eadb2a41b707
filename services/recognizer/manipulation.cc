#include "services/recognizer/manipulation.h"

#include <utility>

namespace cell::recognizer {
namespace {

// An action read backwards begins with its placement.
const Moment& Beginning(const GalleryEntry& entry, Reading reading) {
  return reading == Reading::kForward ? entry.pick : entry.place;
}

const Moment& End(const GalleryEntry& entry, Reading reading) {
  return reading == Reading::kForward ? entry.place : entry.pick;
}

}  // namespace

Manipulation::Manipulation(const Gallery& gallery, std::string part,
                           int64_t pick_index, int64_t pick_utime,
                           std::shared_ptr<const SensedFrame> before)
    : gallery_(&gallery),
      part_(std::move(part)),
      pick_index_(pick_index),
      pick_utime_(pick_utime),
      before_(std::move(before)) {
  for (const Reading reading : {Reading::kReversed, Reading::kForward}) {
    for (const GalleryEntry& entry : gallery.entries()) {
      for (const Binding& binding : gallery.BindingsFor(entry, part_)) {
        if (gallery.MayBe(Beginning(entry, reading), binding, *before_)) {
          hypotheses_.push_back({&entry, binding, reading});
        }
      }
    }
  }
}

std::vector<Manipulation::Hypothesis> Manipulation::CompletedBy(
    const SensedFrame& after) const {
  std::vector<Hypothesis> completed;
  for (const Hypothesis& hypothesis : hypotheses_) {
    if (gallery_->MustBe(End(*hypothesis.entry, hypothesis.reading),
                         hypothesis.binding, after)) {
      completed.push_back(hypothesis);
    }
  }
  return completed;
}

}  // namespace cell::recognizer
