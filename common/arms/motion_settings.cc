#include "common/arms/motion_settings.h"

#include "common/geometry/degree.h"

namespace cell {
namespace {

constexpr double kMm = 1e-3;

}  // namespace

MotionSettings MotionSettings::FromConfig(const Config& config) {
  return {
      .transit_speed = kDegree * config.Number("transit_speed_deg_s", 1, 180),
      .transit_acceleration =
          kDegree * config.Number("transit_acceleration_deg_s2", 1, 2000),
      .line_speed = kMm * config.Number("line_speed_mm_s", 1, 1000),
      .clearance = kMm * config.Number("clearance_mm", 0, 100),
      .approach = kMm * config.Number("approach_mm", 10, 300),
      .raise = kMm * config.Number("raise_mm", 1, 300),
  };
}

FingerSettings FingerSettings::FromConfig(const Config& config) {
  return {kMm * config.Number("open_margin_mm", 1, 50),
          kMm * config.Number("close_beyond_mm", 1, 50)};
}

}  // namespace cell
