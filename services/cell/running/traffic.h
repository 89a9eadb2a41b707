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

/// The traffic of a cell's bus and the health of its services, for `cell top`.
/// Pure: the caller passes the length of a period.
class Traffic {
 public:
  struct Channel {
    std::string name;
    double rate_hz = 0;
    double bytes_per_s = 0;
    int64_t num_lost = 0;      ///< not received by this process
    int64_t num_rejected = 0;  ///< by services, in all
  };
  struct Process {
    std::string name;
    /// Share of one, between its last two HEALTHs that were looked at; nothing
    /// as long as there is one only.
    std::optional<double> processor;
    int64_t resident_bytes = 0;
    int64_t num_lost = 0;  ///< messages that did not reach it, in all
    int64_t num_late = 0;
    int64_t num_unknown_senders = 0;
  };
  struct Report {
    std::vector<Channel> channels;   // by name
    std::vector<Process> processes;  // by name
    int64_t num_foreign = 0;  ///< messages of no member of the cell, in all
    bool is_silent() const { return channels.empty() && processes.empty(); }
  };

  /// `num_services` listed in the roster.
  explicit Traffic(size_t num_services) : arrivals_(num_services) {}

  /// What came on the bus: the message, nothing if it is none of the cell's.
  std::optional<Message> OnMessage(const std::string& channel, Bytes bytes);
  /// What came on the control port, when [s].
  void OnControl(const std::string& channel, Bytes bytes, double now_s);

  /// True if the next report knows the processor time of every service, or no
  /// cell is heard.
  bool KnowsProcessorTimes() const;
  /// Of the period since the last call, that has lasted `seconds`.
  Report MakeReport(double seconds);

 private:
  void OnMessage(const Message& message);
  void OnHealth(const health_t& health, double now_s);
  void OnStatus(const status_t& status);

  struct Count {
    int64_t messages = 0;
    int64_t bytes = 0;
  };
  struct Health {
    health_t last{};
    double last_s = 0;  // when it came
    double before_s = 0;
    int64_t cpu_us_before = 0;
    std::optional<double> processor;

    bool has_two() const { return last_s > before_s; }
  };

  Arrivals arrivals_;
  std::map<std::string, Count> counts_;   // in the period, by channel
  std::map<std::string, Health> health_;  // by service
  /// By service and channel.
  std::map<std::string, std::map<std::string, int64_t>> rejected_;
  int64_t num_foreign_ = 0;
};

}  // namespace cell::cli
