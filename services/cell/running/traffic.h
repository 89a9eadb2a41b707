#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cell/health_t.hpp"
#include "cell/status_t.hpp"
#include "common/bus/arrivals.h"
#include "common/bus/message.h"

namespace cell::cli {

/// What passes on a cell's bus and how its services fare, for `cell top`. Pure:
/// whoever watches says how long a period lasted.
class Traffic {
 public:
  struct Channel {
    std::string name;
    double rate_hz = 0;
    double bytes_per_s = 0;
    int64_t num_lost = 0;      ///< that this watcher did not hear, in all
    int64_t num_rejected = 0;  ///< by services, in all
  };
  struct Process {
    std::string name;
    double processor = 0;  ///< share of one, in the period
    int64_t resident_bytes = 0;
    int64_t num_lost = 0;  ///< messages that did not reach it, in all
    int64_t num_late = 0;
    int64_t num_strangers = 0;
  };
  struct Report {
    std::vector<Channel> channels;   // by name
    std::vector<Process> processes;  // by name
    int64_t num_foreign = 0;  ///< messages of no member of the cell, in all
  };

  /// `num_services` listed in the roster.
  explicit Traffic(size_t num_services) : arrivals_(num_services) {}

  /// What came on the bus: the message, nothing if it is none of the cell's.
  std::optional<Message> Hear(const std::string& channel, Bytes bytes);
  /// What came on the control port.
  void HearControl(const std::string& channel, Bytes bytes);

  /// Of the period since the last call, that has lasted `seconds`.
  Report Take(double seconds);

 private:
  void Hear(const Message& message);
  void Hear(const health_t& health);
  void Hear(const status_t& status);

  struct Count {
    int64_t messages = 0;
    int64_t bytes = 0;
  };
  struct Health {
    health_t last{};
    int64_t cpu_us_before = -1;  // at the period's beginning
  };

  Arrivals arrivals_;
  std::map<std::string, Count> counts_;   // in the period, by channel
  std::map<std::string, Health> health_;  // by service
  /// By service and channel.
  std::map<std::string, std::map<std::string, int64_t>> rejected_;
  int64_t num_foreign_ = 0;
};

}  // namespace cell::cli
