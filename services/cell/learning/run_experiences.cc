#include "services/cell/learning/run_experiences.h"

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cell/asked_skill_t.hpp"
#include "cell/attempt_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/run_log.h"
#include "common/experiences/experience_tracer.h"
#include "common/node/run_service.h"
#include "common/relational/ground_action.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/planner/planner_messages.h"

namespace cell::cli {
namespace {

/// Feeds the messages of a run to a tracer for each episode.
class RunReader {
 public:
  explicit RunReader(const RuleWorld& world)
      : world_(world),
        robot_actions_(
            GroundActions(world.actions(), world.vocabulary(), Agent::kRobot)),
        tracer_(world) {}

  void Put(const Message& message) {
    if (message.channel == "EPISODE") Take(Decode<episode_t>(message));
    if (message.channel == "PREDICATES") Take(Decode<predicates_t>(message));
    if (message.channel == "ACTION") Take(Decode<recognised_action_t>(message));
    if (message.channel == "ATTEMPT") Take(Decode<attempt_t>(message));
    if (message.channel == "SKILL_REQUEST") {
      Take(Decode<asked_skill_t>(message));
    }
    if (message.channel == "SKILL_RESULT") {
      Take(Decode<skill_result_t>(message));
    }
  }

  std::vector<rules::Experience> Finish() {
    EndEpisode();
    return std::move(experiences_);
  }

 private:
  struct Request {
    GroundAction action;
    int64_t utime;
  };

  void EndEpisode() {
    for (rules::Experience& experience : tracer_->Experiences()) {
      experiences_.push_back(std::move(experience));
    }
    tracer_.emplace(world_);
    requests_.clear();
  }

  void Take(const std::optional<episode_t>& message) {
    if (message && message->phase == episode_t::START) EndEpisode();
  }

  void Take(const std::optional<predicates_t>& message) {
    if (!message) return;
    const auto sensed = planner::FromMessage(*message, world_.vocabulary());
    if (sensed) {
      tracer_->Sensed(sensed->key_frame, sensed->utime, sensed->state);
    }
  }

  void Take(const std::optional<recognised_action_t>& message) {
    if (!message) return;
    const int64_t pick = message->pick_key_frame;
    const int64_t place = message->place_key_frame;
    const auto action =
        message->kind == recognised_action_t::UNKNOWN
            ? std::nullopt
            : FindGroundAction(world_.actions(), world_.vocabulary(),
                               message->name, message->arguments);
    if (!action) return tracer_->Moved(pick, place);
    if (message->kind == recognised_action_t::FORWARD) {
      return tracer_->Done(*action, pick, place);
    }
    const auto undoing = UndoingOf(*action);
    if (undoing) return tracer_->Done(*undoing, pick, place);
    tracer_->Reversed(*action, pick, place);
  }

  void Take(const std::optional<asked_skill_t>& message) {
    if (!message) return;
    for (const GroundAction& action : robot_actions_) {
      if (Names(*message, action)) {
        requests_.insert_or_assign(message->id,
                                   Request{action, message->header.utime});
        return;
      }
    }
  }

  void Take(const std::optional<skill_result_t>& message) {
    if (!message || message->outcome != skill_result_t::FAILED) return;
    const auto request = requests_.find(message->id);
    if (request == requests_.end()) return;
    tracer_->Failed(request->second.action, request->second.utime,
                    message->header.utime);
  }

  void Take(const std::optional<attempt_t>& message) {
    if (!message) return;
    const auto find = [&](const std::vector<std::string>& arguments) {
      return FindGroundAction(world_.actions(), world_.vocabulary(),
                              message->name, arguments);
    };
    auto action = find({message->part, message->site});
    if (!action) action = find({message->part});
    if (!action) return;
    tracer_->Attempted(*action, message->begin_utime, message->header.utime);
  }

  /// What undoes the action; nullopt if nothing does.
  std::optional<GroundAction> UndoingOf(const GroundAction& action) const {
    for (size_t i = 0; i < world_.actions().size(); ++i) {
      if (world_.actions()[i].undoes == action.action) {
        return GroundAction{static_cast<int>(i), action.arguments};
      }
    }
    return std::nullopt;
  }

  /// True if the request is for the skill of the action.
  bool Names(const asked_skill_t& request, const GroundAction& action) const {
    const auto& skill =
        world_.actions()[static_cast<size_t>(action.action)].skill;
    if (!skill) return false;
    const GroundSkill wanted = Bind(*skill, action.arguments);
    const auto name_of = [&](int object) {
      return world_.vocabulary().objects()[static_cast<size_t>(object)].name;
    };
    if (wanted.name != request.skill || name_of(wanted.arm) != request.arm ||
        wanted.arguments.size() != request.arguments.size()) {
      return false;
    }
    for (const argument_t& argument : request.arguments) {
      const auto it = wanted.arguments.find(argument.name);
      if (it == wanted.arguments.end() ||
          name_of(it->second) != argument.value) {
        return false;
      }
    }
    return true;
  }

  const RuleWorld& world_;
  std::vector<GroundAction> robot_actions_;
  std::optional<ExperienceTracer> tracer_;
  std::map<int64_t, Request> requests_;
  std::vector<rules::Experience> experiences_;
};

}  // namespace

std::vector<rules::Experience> ExperiencesOfRun(const RunFolder& run,
                                                const RuleWorld& world) {
  RunReader reader(world);
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [tick, entry] : log.ticks()) {
    for (const Message& message : entry.messages) reader.Put(message);
  }
  return reader.Finish();
}

std::vector<rules::Experience> ExperiencesOfSimulation(
    const Deployment& deployment, const Roster& roster,
    const std::string& script, uint64_t seed, const RuleWorld& world) {
  SimBus bus(roster, AllServices(deployment, script, seed));
  RunReader reader(world);
  const auto& stop = StopOnSignals();
  RunToEnd(bus, [&](const Message& message) {
    if (stop) throw std::runtime_error("stopped");
    reader.Put(message);
  });
  return reader.Finish();
}

RuleWorld RuleWorldOf(const Domain& domain) {
  return RuleWorld(std::make_shared<const Vocabulary>(domain.vocabulary()),
                   domain.actions());
}

}  // namespace cell::cli
