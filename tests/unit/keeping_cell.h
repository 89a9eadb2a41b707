#pragma once

#include <map>
#include <memory>
#include <string>

#include "cell/action_record_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/library_request_t.hpp"
#include "common/actions/record_messages.h"
#include "common/bus/clock_host.h"
#include "common/bus/roster.h"
#include "common/experiences/experience_record.h"
#include "services/library/library.h"
#include "services/library/open_store.h"
#include "services/recorder/recorder.h"

/// A cell with many new actions and experiences: a clock, a service that asks
/// the library to keep them, the library, and a recorder.
namespace cell::keeping {

using namespace library;
using namespace recorder;

inline constexpr int32_t kRequestPeriod = 40;  ///< [ticks] of LIBRARY_REQUEST

/// An action that the shipped task's library keeps.
inline ActionRecord Good(const std::string& name) {
  ActionRecord record;
  record.name = name;
  record.arguments = {{"X", "movable"}};
  record.agents = {"person"};
  record.rules =
      "- {context: [Clear(X)], outcomes: [{probability: 0.9, effects: [not "
      "Clear(X)]}], noise: 0.1}";
  return record;
}

/// What is asked in this tick: a new action, or one that is refused.
inline ActionRecord RequestOf(int32_t tick) {
  ActionRecord record = Good("Learned" + std::to_string(tick));
  if (tick % 10 == 3) record.name = "Learned" + std::to_string(tick - 1);
  if (tick % 10 == 7) record.rules = "- nonsense";
  return record;
}

/// What is asked to be kept as an experience in this tick: one of an action
/// that the library knows, or will; or one that is refused.
inline ExperienceRecord ExperienceRequestOf(int32_t tick) {
  ExperienceRecord experience;
  experience.action = "Learned" + std::to_string(tick + tick % 4);
  experience.objects = {"shaft"};
  experience.agent = tick % 3 == 0 ? "robot" : "person";
  experience.before = {"Clear(shaft)"};
  experience.after = {"?Clear(shaft)", "Clear(separator)"};
  if (tick % 10 == 4) experience.after = {"Clear(nobody)"};
  return experience;
}

/// Begins an episode in tick 3, ends the run.
class Time final : public Service {
 public:
  Time(Bus& bus, int32_t num_ticks) {
    bus.Every(1, 0, [&bus, num_ticks] {
      if (bus.tick() == 1) bus.EndRunIn(num_ticks);
      if (bus.tick() != 3) return;
      episode_t episode{};
      episode.header.utime = bus.now();
      episode.phase = episode_t::START;
      bus.Publish("EPISODE", episode);
    });
  }
};

/// Asks in every tick from 5 on, and at times for all that there is.
class Asker final : public Service {
 public:
  explicit Asker(Bus& bus) {
    bus.Every(1, 0, [&bus] {
      if (bus.tick() < 5) return;
      action_record_t request = ToMessage(RequestOf(bus.tick()));
      request.header.utime = bus.now();
      bus.Publish("STORE_REQUEST", request);
      experience_t experience = ToMessage(ExperienceRequestOf(bus.tick()));
      experience.header.utime = bus.now();
      bus.Publish("EXPERIENCE_REQUEST", experience);
      if (bus.tick() % kRequestPeriod != 0) return;
      library_request_t all{};
      all.header.utime = bus.now();
      bus.Publish("LIBRARY_REQUEST", all);
    });
  }
};

inline Roster TheRoster() {
  return {.task = "cranfield",
          .entries = {{"time"}, {"asker"}, {"library"}, {"recorder"}}};
}

/// The incarnations of the library share one store, opened by the first.
inline std::map<std::string, ServiceFactory> Factories(
    const Deployment& deployment, int32_t num_ticks) {
  return {
      {"time",
       [=](Bus& bus) {
         return std::make_unique<Time>(bus, num_ticks);
       }},
      {"asker",
       [](Bus& bus) {
         return std::make_unique<Asker>(bus);
       }},
      {"library",
       [deployment, store = std::shared_ptr<ActionStore>()](Bus& bus) mutable {
         if (!store) store = OpenStore(deployment, {});
         return MakeLibrary(bus, deployment, store);
       }},
      {"recorder", [=](Bus& bus) {
         return MakeRecorder(bus, deployment);
       }}};
}

}  // namespace cell::keeping
