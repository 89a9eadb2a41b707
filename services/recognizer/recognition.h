#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/config/config.h"
#include "common/predicates/predicate_sensor.h"
#include "common/scene/scene_objects.h"
#include "common/sec/sec_library.h"
#include "services/recognizer/manipulation.h"

namespace cell::recognizer {

/// A manipulation that was recognised.
struct RecognisedAction {
  ActionDirection direction = ActionDirection::kUnknown;
  std::string name;  ///< empty if unknown
  /// From 0 to 1; of an unknown one: that it is none of those known.
  double confidence = 0;
  std::vector<std::string> arguments;  ///< in the action's order
  /// One of them stands in for what the action was shown with.
  bool has_stand_in = false;
  std::string part;                ///< what was moved
  std::vector<std::string> hands;  ///< that held it, sorted
  int64_t pick_utime = 0;
  int64_t pick_key_frame = 0;
  int64_t place_utime = 0;
  int64_t place_key_frame = 0;
};

/// Finds manipulations in an unsegmented stream of key frames (section VII-A):
/// a part is picked up when the first hand touches it and placed when the last
/// one leaves it. What the two key frames agree with is recognised, forward or
/// reversed; a part that was moved otherwise is an unknown manipulation; one
/// that was only touched, or carried along by another, is none.
class Recognition {
 public:
  struct Params {
    double moved = 0.010;   ///< [m] further: the part was moved
    double turned = 0.175;  ///< [rad] more: it was moved; up to its symmetry

    /// Of recognizer.yaml, the keys that are about recognition.
    /// @throws ConfigError naming file:key.
    static Params Load(const Config& config);
  };

  Recognition(const SceneObjects& scene_objects, const PartTable& parts,
              std::shared_ptr<const SecLibrary> library,
              std::shared_ptr<const PredicateSensor> sensor,
              const Params& params);

  /// Called with each manipulation that is reported, and what it is read as.
  using Observer = std::function<void(const ObservedManipulation&,
                                      const std::vector<RecognisedAction>&)>;
  void SetObserver(Observer observer) { observer_ = std::move(observer); }

  /// @pre frames come in their order.
  std::vector<RecognisedAction> Update(const KeyFrame& frame);

  /// What is picked up from now on is read with this library.
  void Use(std::shared_ptr<const SecLibrary> library) {
    library_ = std::move(library);
  }

  /// Of parts that are in hands now.
  const std::map<std::string, Manipulation>& manipulations() const {
    return manipulations_;
  }

 private:
  std::vector<std::string> HandsOn(const std::string& part,
                                   const TouchGraph& graph) const;
  void UpdateHeld(const std::shared_ptr<const SensedFrame>& now,
                  std::vector<Manipulation>& placed);
  bool WasMoved(const Manipulation& manipulation,
                const SensedFrame& after) const;
  bool WasCarriedAlong(const Manipulation& manipulation,
                       const SensedFrame& after) const;
  bool WasHeldSince(const std::string& part, int64_t index) const;
  bool Rode(const std::string& part, const std::string& carrier,
            const SensedFrame& before, const SensedFrame& after) const;
  void Observe(const Manipulation& manipulation,
               const std::vector<RecognisedAction>& actions,
               const SensedFrame& after) const;
  RecognisedAction Report(const Manipulation& manipulation,
                          const Manipulation::Reading* reading,
                          const SensedFrame& after);

  SceneObjects scene_objects_;
  PartTable parts_;
  std::shared_ptr<const SecLibrary> library_;
  std::shared_ptr<const PredicateSensor> sensor_;
  Params params_;
  Observer observer_;
  std::shared_ptr<const SensedFrame> previous_;
  std::map<std::string, Manipulation> manipulations_;  // by part
  std::map<std::string, int64_t> last_placed_;  // key frame, of those reported
};

}  // namespace cell::recognizer
