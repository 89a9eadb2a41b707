#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "common/sec/event_chain.h"
#include "common/sec/sec_library.h"

namespace cell::recognizer {

/// A part in a person's hands, from the pick-up on, with every action in every
/// roles that the key frames so far may turn out to be.
class Manipulation {
 public:
  struct Hypothesis {
    std::shared_ptr<const SecModel> model;
    SecModel::Roles roles;
    ActionDirection direction;  // forward or reversed
  };
  /// A hypothesis that the whole manipulation agrees with.
  struct Reading {
    Hypothesis hypothesis;
    double agreement = 0;  // from 0 to 1
    /// The mean of the agreement and of its lead over the best other reading,
    /// which does not hold along with it.
    double confidence = 0;
  };
  struct PickUp {
    std::string part;
    int64_t index = 0;  ///< key frame
    int64_t utime = 0;  ///< [us]
    /// The key frame before the pick-up: the hand has not moved anything yet.
    std::shared_ptr<const SensedFrame> before;
  };

  /// @pre `pick_up.before` is not null.
  Manipulation(const SecLibrary& library, PickUp pick_up);

  void AddHand(const std::string& hand) { hands_.insert(hand); }
  /// A key frame from the pick-up on.
  void Append(const TouchGraph& relations) { chain_.Append(relations); }

  /// How well each hypothesis agrees with the manipulation if it ends in
  /// `after`, in their order: from 0 to 1.
  std::vector<double> Agreements(const SensedFrame& after) const;
  /// Of the hypotheses of each direction those that agree best with the
  /// manipulation that ends in `after`, if they reach the threshold: it may
  /// undo one action and do another. Those reversed come first: what was undone
  /// came before what was done.
  std::vector<Reading> CompletedBy(const SensedFrame& after) const;

  /// How sure it is that the manipulation which ends in `after` is none of the
  /// hypotheses: what the best of them lacks.
  double ConfidenceInNone(const SensedFrame& after) const;

  const std::string& part() const { return pick_up_.part; }
  const std::set<std::string>& hands() const { return hands_; }
  int64_t pick_index() const { return pick_up_.index; }
  int64_t pick_utime() const { return pick_up_.utime; }
  const SensedFrame& before() const { return *pick_up_.before; }
  /// From the key frame before the pick-up on.
  const EventChain& chain() const { return chain_; }
  /// Not yet contradicted, first those reversed.
  const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }

 private:
  PickUp pick_up_;
  double threshold_;
  EventChain chain_;
  std::set<std::string> hands_;
  std::vector<Hypothesis> hypotheses_;
};

}  // namespace cell::recognizer
