#pragma once

#include <memory>
#include <string>
#include <utility>

#include "cell/alert_t.hpp"
#include "cell/counter_t.hpp"
#include "cell/status_t.hpp"
#include "common/bus/clock_host.h"
#include "common/bus/roster.h"

namespace cell::toy {

/// A message that carries one number.
inline status_t Number(int64_t utime, int64_t value) {
  status_t message{};
  message.header.utime = utime;
  message.num_counters = 1;
  message.counters.resize(1);
  message.counters[0].value = value;
  return message;
}

/// The clock's own service: counts ticks on SOURCE, takes what comes back on
/// SUM, ends the run after `num_ticks`.
class Source : public Service {
 public:
  Source(Bus& bus, int32_t num_ticks) {
    bus.Subscribe<status_t>("SUM", [this](const status_t& message) {
      total_ += message.counters.at(0).value;
    });
    bus.Subscribe<status_t>("COMMAND_ADD", [this](const status_t& message) {
      total_ += message.counters.at(0).value;
    });
    bus.Every(1, 0, [this, &bus, num_ticks] {
      if (bus.tick() == 1) bus.EndRunIn(num_ticks);
      bus.Publish("SOURCE", Number(bus.now(), total_ + bus.tick()));
    });
  }

 private:
  int64_t total_ = 0;
};

/// Adds up what comes on `from` and says the sum on `to`.
class Adder : public Service {
 public:
  Adder(Bus& bus, const std::string& from, const std::string& to) {
    bus.Subscribe<status_t>(from, [this, &bus, to](const status_t& message) {
      if (message.num_counters != 1) return false;
      sum_ = (sum_ + message.counters[0].value) % 1'000'003;
      bus.Publish(to, Number(message.header.utime, sum_));
      return true;
    });
    bus.Every(5, 2,
              [this, &bus, to] { bus.Publish(to, Number(bus.now(), -sum_)); });
  }

 private:
  int64_t sum_ = 0;
};

/// source -> first -> second (slow) -> source and third
inline Roster ToyRoster(int32_t slow_latency = 3) {
  return {.task = "toy",
          .entries = {{"source", 1, ""},
                      {"first", 1, ""},
                      {"second", slow_latency, ""},
                      {"third", 1, ""}}};
}

inline std::map<std::string, ServiceFactory> ToyFactories(int32_t num_ticks) {
  return {{"source",
           [num_ticks](Bus& bus) {
             return std::make_unique<Source>(bus, num_ticks);
           }},
          {"first",
           [](Bus& bus) {
             return std::make_unique<Adder>(bus, "SOURCE", "DOUBLE");
           }},
          {"second",
           [](Bus& bus) {
             return std::make_unique<Adder>(bus, "DOUBLE", "SUM");
           }},
          {"third", [](Bus& bus) {
             return std::make_unique<Adder>(bus, "SUM", "ECHO");
           }}};
}

}  // namespace cell::toy
