#include "services/robot_arm/safety_distances.h"

namespace cell::robot_arm {

SafetyDistances SafetyDistances::FromConfig(const Config& config) {
  constexpr double kMm = 1e-3;
  SafetyDistances distances;
  distances.hands = kMm * config.Number("hands_mm", 20, 1000);
  distances.hands_at_work = kMm * config.Number("hands_at_work_mm", 20, 1000);
  distances.hands_too_near = kMm * config.Number("hands_too_near_mm", 0, 1000);
  distances.in_hand = kMm * config.Number("in_hand_mm", 1, 100);
  distances.standing_arm = kMm * config.Number("standing_arm_mm", 1, 500);
  distances.moving_arm = kMm * config.Number("moving_arm_mm", 1, 500);
  distances.patience = config.Number("patience_s", 0, 600);
  if (distances.hands_too_near > distances.hands_at_work) {
    config["hands_too_near_mm"].Fail("lies above hands_at_work_mm");
  }
  return distances;
}

}  // namespace cell::robot_arm
