#include "services/planner/execution_messages.h"

#include <algorithm>
#include <cmath>

#include "cell/motion_permit_t.hpp"
#include "common/skills/skill_arguments.h"

namespace cell::planner {
namespace {

constexpr size_t kMaxSkills = 100;  // of an arm

bool IsTimeUntil(int64_t utime, int64_t now) {
  return utime >= 0 && utime <= now;
}

/// The objects of the names; nullopt unless all are known and in order.
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

std::optional<SkillResult::Outcome> OutcomeOf(int8_t code) {
  switch (code) {
    case skill_result_t::SUCCEEDED:
      return SkillResult::Outcome::kSucceeded;
    case skill_result_t::REFUSED:
      return SkillResult::Outcome::kRefused;
    case skill_result_t::FAILED:
      return SkillResult::Outcome::kFailed;
    case skill_result_t::STOPPED:
      return SkillResult::Outcome::kStopped;
    case skill_result_t::YIELDED:
      return SkillResult::Outcome::kYielded;
    default:
      return std::nullopt;
  }
}

int8_t CodeOf(ExecutionStatus::State state) {
  switch (state) {
    case ExecutionStatus::State::kRunning:
      return execution_t::RUNNING;
    case ExecutionStatus::State::kDone:
      return execution_t::DONE;
    case ExecutionStatus::State::kStuck:
      return execution_t::STUCK;
  }
  return execution_t::STUCK;
}

literal_t ToMessage(const RequiredChange& change,
                    const Vocabulary& vocabulary) {
  const GroundAtom atom = vocabulary.Atom(change.atom);
  literal_t literal{};
  literal.predicate = vocabulary.predicates()[atom.predicate].name;
  for (const int object : atom.objects) {
    literal.arguments.push_back(vocabulary.objects()[object].name);
  }
  literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
  literal.value =
      change.truth == Truth::kTrue ? literal_t::TRUE_ : literal_t::FALSE_;
  return literal;
}

/// `_`: any object.
literal_t ToMessage(const Literal& literal, const Vocabulary& vocabulary) {
  literal_t message{};
  message.predicate =
      vocabulary.predicates()[static_cast<size_t>(literal.relation)].name;
  for (const Term& term : literal.terms) {
    message.arguments.push_back(term.kind == Term::Kind::kObject
                                    ? vocabulary.objects()[term.index].name
                                    : "_");
  }
  message.num_arguments = static_cast<int32_t>(message.arguments.size());
  message.value = literal.is_negated ? literal_t::FALSE_ : literal_t::TRUE_;
  return message;
}

}  // namespace

std::optional<ArmState> FromMessage(const arm_report_t& message,
                                    const Vocabulary& vocabulary, int64_t now) {
  const auto arm = vocabulary.FindObject(message.arm);
  const auto reachable = ObjectsOf(message.reachable, vocabulary);
  if (!arm || !reachable || message.request < ArmState::kIdle ||
      message.skills.size() > kMaxSkills ||
      !IsTimeUntil(message.header.utime, now)) {
    return std::nullopt;
  }
  ArmState report{*arm, message.header.utime, message.request, std::nullopt,
                  *reachable};
  for (const skill_traits_t& skill : message.skills) {
    report.skills[skill.name] = {.may_run_beside = skill.may_run_beside != 0,
                                 .hands_over = skill.hands_over != 0};
  }
  if (message.held.empty()) return report;
  report.held = vocabulary.FindObject(message.held);
  if (!report.held) return std::nullopt;
  return report;
}

std::optional<SkillResult> FromMessage(const skill_result_t& message,
                                       const Vocabulary& vocabulary,
                                       int64_t now) {
  const auto arm = vocabulary.FindObject(message.arm);
  const auto outcome = OutcomeOf(message.outcome);
  if (!arm || !outcome || message.id < 0 ||
      !IsTimeUntil(message.header.utime, now) ||
      !std::isfinite(message.peak_force) || message.peak_force < 0) {
    return std::nullopt;
  }
  return SkillResult{message.id, message.header.utime, *arm, *outcome,
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

asked_skill_t ToMessage(const SkillRequest& request,
                        const Vocabulary& vocabulary) {
  const auto& objects = vocabulary.objects();
  asked_skill_t message{};
  message.id = request.id;
  message.deadline_utime = request.deadline_utime;
  message.arm = objects[request.arm].name;
  message.skill = request.skill;
  message.is_careful = request.is_careful ? 1 : 0;
  SkillArguments arguments;
  for (const auto& [name, object] : request.arguments) {
    arguments[name] = objects[object].name;
  }
  SetArguments(arguments, &message);
  return message;
}

execution_t ToMessage(const ExecutionStatus& status, const RuleSet& rules) {
  execution_t message{};
  message.state = CodeOf(status.state);
  message.action = status.action;
  message.text = status.text;
  message.formula = status.formula;
  for (const RequiredChange& change : status.needed) {
    message.needed.push_back(ToMessage(change, rules.vocabulary()));
  }
  for (const Literal& literal : status.unlearned) {
    message.needed.push_back(ToMessage(literal, rules.vocabulary()));
  }
  message.num_needed = static_cast<int32_t>(message.needed.size());
  const auto skill = status.step ? rules.SkillOf(*status.step) : std::nullopt;
  if (skill && skill->arguments.contains("site") &&
      skill->arguments.contains("part")) {
    const auto& objects = rules.vocabulary().objects();
    message.help_part = objects[skill->arguments.at("part")].name;
    message.help_site = objects[skill->arguments.at("site")].name;
  }
  return message;
}

}  // namespace cell::planner
