#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/relational/state.h"
#include "common/scene/key_frame.h"
#include "common/sec/event_chain.h"

namespace cell {

/// A key frame and what is sensed in it.
struct SensedFrame {
  KeyFrame frame;
  State state;
};

/// How an action is read in a manipulation: done, undone, or none is known.
enum class ActionDirection : int8_t {
  kForward = 0,
  kReversed = 1,
  kUnknown = 2
};

/// A manipulation that has ended.
struct ObservedManipulation {
  std::string part;           ///< that was moved
  const SensedFrame& before;  ///< the key frame before its pick-up
  const SensedFrame& after;   ///< the key frame of its placement
  EventChain chain;           ///< of all pairs, from `before` to `after`
};

/// Something that a model says of a manipulation, and whether it is so.
struct CheckedFact {
  enum class When : int8_t {
    kBefore,      ///< the pick-up
    kAfter,       ///< the placement
    kUnexplained  ///< it changed, but the model does not mention it
  };
  When when = When::kBefore;
  std::string text;   ///< "touches table"
  double weight = 0;  ///< in the agreement
  double share = 0;   ///< that holds: 0, 1, or between if it is open
  /// Without it there is no such action.
  bool is_required = false;
};

/// How an action shows in a semantic event chain (section VII-A).
class SecModel {
 public:
  /// Objects of the action's arguments, in their order, by name.
  using Roles = std::vector<std::string>;

  SecModel() = default;
  SecModel(const SecModel&) = delete;
  SecModel& operator=(const SecModel&) = delete;
  virtual ~SecModel() = default;

  /// The action's name.
  virtual const std::string& action() const = 0;
  /// All roles in which a manipulation of `part` that begins after `before` may
  /// turn out to be the action; read forward or reversed.
  virtual std::vector<Roles> RolesAtPickUp(const std::string& part,
                                           const SensedFrame& before,
                                           ActionDirection direction) const = 0;
  /// True if an object of these roles only stands in for those that the action
  /// was shown with.
  virtual bool HasStandIn(const Roles& /*roles*/) const { return false; }
  /// How well the manipulation agrees with the action in one of these roles:
  /// from 0 to 1.
  virtual double Agreement(const ObservedManipulation& manipulation,
                           const Roles& roles,
                           ActionDirection direction) const = 0;
  /// What the agreement is made of, for people. Models that are not made of
  /// facts have none.
  virtual std::vector<CheckedFact> Check(
      const ObservedManipulation& /*manipulation*/, const Roles& /*roles*/,
      ActionDirection /*direction*/) const {
    return {};
  }
};

/// The actions that can be recognised. A manipulation is read as those models
/// and roles that agree with it best, if they reach the threshold.
class SecLibrary {
 public:
  using Models = std::vector<std::shared_ptr<const SecModel>>;

  SecLibrary() = default;
  SecLibrary(const SecLibrary&) = delete;
  SecLibrary& operator=(const SecLibrary&) = delete;
  virtual ~SecLibrary() = default;

  virtual const Models& models() const = 0;
  /// The least agreement of a manipulation that is known.
  virtual double threshold() const = 0;
};

}  // namespace cell
