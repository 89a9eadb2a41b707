#include "services/planner/executor_messages.h"

#include <algorithm>
#include <cmath>

#include "cell/motion_permit_t.hpp"

namespace cell::planner {
namespace {

bool IsTimeUntil(int64_t utime, int64_t now) {
  return utime >= 0 && utime <= now;
}

/// The objects of the names; nothing unless all are known and in order.
std::optional<std::vector<int>> ObjectsOf(const std::vector<std::string>& names,
                                          const Vocabulary& vocabulary) {
  std::vector<int> objects;
  for (const std::string& name : names) {
    const std::optional<int> object = vocabulary.FindObject(name);
    // Objects are in the order of their names.
    if (!object || (!objects.empty() && *object <= objects.back())) {
      return std::nullopt;
    }
    objects.push_back(*object);
  }
  return objects;
}

std::optional<ArmOutcome::Outcome> OutcomeOf(int8_t code) {
  switch (code) {
    case skill_result_t::SUCCEEDED:
      return ArmOutcome::Outcome::kSucceeded;
    case skill_result_t::REFUSED:
      return ArmOutcome::Outcome::kRefused;
    case skill_result_t::FAILED:
      return ArmOutcome::Outcome::kFailed;
    case skill_result_t::STOPPED:
      return ArmOutcome::Outcome::kStopped;
    case skill_result_t::YIELDED:
      return ArmOutcome::Outcome::kYielded;
    default:
      return std::nullopt;
  }
}

int8_t CodeOf(ArmOrder::Kind kind) {
  switch (kind) {
    case ArmOrder::Kind::kInsert:
      return skill_request_t::INSERT;
    case ArmOrder::Kind::kPresent:
      return skill_request_t::PRESENT;
    case ArmOrder::Kind::kPutDown:
      return skill_request_t::PUT_DOWN;
    case ArmOrder::Kind::kGoHome:
      return skill_request_t::GO_HOME;
    case ArmOrder::Kind::kGoFree:
      return skill_request_t::GO_FREE;
  }
  return skill_request_t::GO_HOME;
}

int8_t CodeOf(Execution::State state) {
  switch (state) {
    case Execution::State::kRunning:
      return execution_t::RUNNING;
    case Execution::State::kDone:
      return execution_t::DONE;
    case Execution::State::kStuck:
      return execution_t::STUCK;
  }
  return execution_t::STUCK;
}

literal_t ToMessage(const Wish& wish, const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(wish.atom);
  literal_t literal{};
  literal.predicate = vocabulary.predicates()[atom.predicate].name;
  for (const int object : atom.objects) {
    literal.arguments.push_back(vocabulary.objects()[object].name);
  }
  literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
  literal.value =
      wish.truth == Truth::kTrue ? literal_t::TRUE_ : literal_t::FALSE_;
  return literal;
}

}  // namespace

std::optional<ArmStatus> FromMessage(const arm_report_t& message,
                                     const Domain& domain, int64_t now) {
  const Vocabulary& vocabulary = domain.vocabulary();
  const auto arm = vocabulary.FindObject(message.arm);
  const auto reachable = ObjectsOf(message.reachable, vocabulary);
  if (!arm || !reachable || message.request < ArmStatus::kIdle ||
      !IsTimeUntil(message.header.utime, now)) {
    return std::nullopt;
  }
  ArmStatus report{*arm, message.header.utime, message.request, std::nullopt,
                   *reachable};
  if (message.held.empty()) return report;
  report.held = vocabulary.FindObject(message.held);
  if (!report.held) return std::nullopt;
  return report;
}

std::optional<ArmOutcome> FromMessage(const skill_result_t& message,
                                      const Domain& domain, int64_t now) {
  const auto arm = domain.vocabulary().FindObject(message.arm);
  const auto outcome = OutcomeOf(message.outcome);
  if (!arm || !outcome || message.id < 0 ||
      !IsTimeUntil(message.header.utime, now) ||
      !std::isfinite(message.peak_force) || message.peak_force < 0) {
    return std::nullopt;
  }
  return ArmOutcome{message.id, message.header.utime, *arm, *outcome,
                    message.reason};
}

std::optional<bool> MayActFromMessage(const operating_mode_t& message) {
  const bool is_hold = message.mode == motion_permit_t::HOLD;
  const bool has_hold = message.hold != motion_permit_t::NONE;
  if (message.mode < motion_permit_t::IDLE ||
      message.mode > motion_permit_t::HOLD ||
      message.hold < motion_permit_t::NONE ||
      message.hold > motion_permit_t::AT_ONCE || is_hold != has_hold) {
    return std::nullopt;
  }
  return message.mode == motion_permit_t::EXECUTE;
}

skill_request_t ToMessage(const ArmOrder& request, const Domain& domain) {
  const auto& objects = domain.vocabulary().objects();
  skill_request_t message{};
  message.id = request.id;
  message.deadline_utime = request.deadline_utime;
  message.arm = objects[request.arm].name;
  message.skill = CodeOf(request.kind);
  if (request.part) message.part = objects[*request.part].name;
  if (request.site) message.site = objects[*request.site].name;
  return message;
}

execution_t ToMessage(const Execution& execution, const Domain& domain) {
  execution_t message{};
  message.state = CodeOf(execution.state);
  message.action = execution.action;
  message.text = execution.text;
  for (const Wish& wish : execution.needed) {
    message.needed.push_back(ToMessage(wish, domain.vocabulary()));
  }
  message.num_needed = static_cast<int32_t>(message.needed.size());
  const auto skill =
      execution.step ? domain.SkillOf(*execution.step) : std::nullopt;
  if (skill && skill->site) {
    const auto& objects = domain.vocabulary().objects();
    message.help_part = objects[skill->part].name;
    message.help_site = objects[*skill->site].name;
  }
  return message;
}

}  // namespace cell::planner
