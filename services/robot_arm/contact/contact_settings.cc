#include "services/robot_arm/contact/contact_settings.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "common/geometry/degree.h"

namespace cell::robot_arm {
namespace {

constexpr double kMm = 1e-3;

/// Reads the keys of a section that are there.
class Section {
 public:
  explicit Section(const Config& config) : config_(config) {}
  /// It may be missing.
  Section(const Config& config, const std::string& name)
      : config_(config.Has(name) ? std::optional(config[name]) : std::nullopt) {
  }

  /// The number times `unit`, if it is there.
  void Read(const std::string& key, double unit, double low, double high,
            double* value) const {
    if (config_ && config_->Has(key)) {
      *value = unit * config_->Number(key, low, high);
    }
  }
  void Read(const std::string& key, int low, int high, int* value) const {
    if (config_ && config_->Has(key)) {
      *value = config_->Integer(key, low, high);
    }
  }
  /// `low_key` may lie in a section that this one refines.
  void CheckOrder(const std::string& low_key, double low,
                  const std::string& high_key, double high) const {
    if (low <= high || !config_) return;
    const bool has_low = config_->Has(low_key);
    (*config_)[has_low ? low_key : high_key].Fail(
        has_low ? fmt::format("must not lie above {}", high_key)
                : fmt::format("must not lie below {}", low_key));
  }

 private:
  std::optional<Config> config_;
};

void ReadFeed(const Section& feed, StraightFeed::Params* p) {
  feed.Read("push_n", 1, 1, 60, &p->push);
  feed.Read("free_mm_s", kMm, 1, 200, &p->free_feed);
  feed.Read("touch_mm_s", kMm, 1, 50, &p->touch_feed);
  feed.Read("touch_height_mm", kMm, 0, 300, &p->touch_height);
  feed.Read("touch_share", 1, 0.01, 1, &p->touch_share);
  feed.Read("loose_share", 1, 0, 1, &p->loose_share);
  feed.Read("loose_time_s", 1, 0, 10, &p->loose_time);
  feed.CheckOrder("loose_share", p->loose_share, "touch_share", p->touch_share);
}

void ReadAdmittance(const Section& admittance, Admittance::Params* p) {
  // Up to where it is stable (admittance.h).
  admittance.Read("kp_m_per_n", 1, 0, 3e-5, &p->kp);
  admittance.Read("ki_m_per_n_s", 1, 1e-6, 1e-3, &p->ki);
  admittance.Read("kp_turn_rad_per_nm", 1, 0, 4e-3, &p->kp_turn);
  admittance.Read("ki_turn_rad_per_nm_s", 1, 0, 0.15, &p->ki_turn);
  admittance.Read("max_drift_mm", kMm, 0, 50, &p->max_drift);
  admittance.Read("max_turn_rad", 1, 0, 0.5, &p->max_turn);
}

void ReadSearch(const Section& search, SpiralSearch::Params* p) {
  search.Read("pitch_mm", kMm, 0.1, 10, &p->pitch);
  search.Read("speed_mm_s", kMm, 1, 50, &p->speed);
  search.Read("radius_mm", kMm, 0, 20, &p->radius);
  search.Read("found_mm", kMm, 0.01, 10, &p->found);
  search.Read("max_spirals", 0, 100, &p->max_spirals);
  search.CheckOrder("pitch_mm", p->pitch, "radius_mm", p->radius);
}

void ReadDither(const Section& dither, Dither::Params* p) {
  dither.Read("yaw_deg", kDegree, 0, 5, &p->yaw);
  dither.Read("tilt_deg", kDegree, 0, 5, &p->tilt);
  dither.Read("yaw_period_s", 1, 0.1, 10, &p->yaw_period);
  dither.Read("tilt_period_s", 1, 0.1, 10, &p->tilt_period);
  dither.Read("rise_time_s", 1, 0.05, 10, &p->rise_time);
}

void ReadStall(const Section& stall, StallDetector::Params* p) {
  stall.Read("push_share", 1, 0.05, 1, &p->push_share);
  stall.Read("move_mm", kMm, 0.01, 10, &p->move);
  stall.Read("time_s", 1, 0.01, 10, &p->time);
}

void ReadSeat(const Section& seat, SeatedTermination::Params* p) {
  seat.Read("height_mm", kMm, 0, 100, &p->height);
  seat.Read("tolerance_mm", kMm, 0.01, 10, &p->tolerance);
  seat.Read("give_mm", kMm, 0, 10, &p->give);
}

/// What insertions and screwing have in common.
void ReadContact(const Config& config, ContactMotion::Params* p) {
  ReadAdmittance({config, "admittance"}, &p->admittance);
  const Section slow_down(config, "slow_down");
  slow_down.Read("gain_per_n", 1, 0, 10, &p->slow_down.gain);
  slow_down.Read("dead_n", 1, 0, 100, &p->slow_down.dead);
  const Section limits(config, "limits");
  limits.Read("force_n", 1, 1, 500, &p->limits.force);
  limits.Read("time_s", 1, 1, 600, &p->limits.time);
}

}  // namespace

InsertionParams Refined(InsertionParams params, const Config& config) {
  ReadFeed({config, "feed"}, &params.feed);
  ReadContact(config, &params.contact);
  ReadSearch({config, "search"}, &params.contact.search);
  ReadDither({config, "dither"}, &params.contact.dither);
  ReadStall({config, "stall"}, &params.contact.stall);
  ReadSeat({config, "seat"}, &params.seat);
  if (config.Has("aim_mm")) {
    const std::vector<double> aim = config.Numbers("aim_mm", 2);
    params.aim = kMm * Eigen::Vector2d(aim[0], aim[1]);
  }
  return params;
}

ScrewingParams ScrewingFromConfig(const Config& config) {
  const Config thread = config["thread"], tight = config["tight"];
  ScrewingParams params{
      .thread = {.push = thread.Number("push_n", 0, 50),
                 .rate = kDegree * thread.Number("rate_deg_s", 1, 360)},
      .tight = {.torque = tight.Number("torque_nm", 0.01, 20),
                .min_angle = kDegree * tight.Number("min_angle_deg", 0, 720),
                .max_angle = kDegree * tight.Number("max_angle_deg", 0, 720)}};
  const Section section(tight);
  section.CheckOrder("min_angle_deg", params.tight.min_angle, "max_angle_deg",
                     params.tight.max_angle);
  section.Read("early_deg", kDegree, 0, 360, &params.early_angle);
  ReadContact(config, &params.contact);
  return params;
}

ContactSensor::Params ForceSensorFromConfig(const Config& config) {
  ContactSensor::Params params;
  const Section section(config);
  section.Read("cutoff_hz", 1, 1, 60, &params.cutoff);
  section.Read("patience_s", 1, 0.008, 1, &params.patience);
  return params;
}

}  // namespace cell::robot_arm
