#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/bus/roster.h"
#include "common/config/config.h"

namespace cell::supervisor {

/// When arms stop; the later ones are stronger.
enum class Hold {
  kNone,
  kAtBoundary,  ///< running skills are finished, none is begun
  kAtOnce       ///< set-points freeze
};

enum class AlertLevel { kInfo, kWarning, kError };

/// What it means that a service is silent.
struct HoldRow {
  std::string service;
  Hold hold = Hold::kNone;
  int64_t silence_us = 0;  ///< [us] it is thought dead after
  AlertLevel level = AlertLevel::kError;
  std::string meaning;  ///< "the parts are not tracked"
};

/// supervisor.yaml:
///
///   silence_ms: 1200
///   operator_hold: at_once         # or at_boundary
///   services:
///     tracker: {when_silent: at_boundary, level: error, means: no eyes}
///     robot_arm@left: {when_silent: at_once, level: error, means: no hands,
///                      silence_ms: 250}
struct StopPolicy {
  Hold operator_hold = Hold::kAtOnce;
  std::vector<HoldRow> rows;

  /// Every service of the roster has a row but the clock, without which there
  /// is no time, and the supervisor itself. Rows of services that do not take
  /// part in this run are passed over. @throws ConfigError.
  static StopPolicy FromConfig(const Config& config, const Roster& roster,
                               const std::string& self);
};

}  // namespace cell::supervisor
