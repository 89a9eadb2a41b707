#include "services/cell/reporting/narrator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "cell/alert_t.hpp"
#include "cell/answer_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/bus/decode.h"
#include "common/text/counted.h"
#include "common/text/printable.h"

namespace cell::cli {
namespace {

constexpr double kSecond = 1e6;

std::string Line(int64_t utime, const std::string& text) {
  return fmt::format("{:8.2f} s  {}", static_cast<double>(utime) / kSecond,
                     Printable(text));
}

std::string Continued(const std::string& text) {
  return fmt::format("{:12}{}", "", Printable(text));
}

template <class Callable>
std::string Call(const Callable& callable, const std::string& name) {
  return fmt::format("{}({})", name, fmt::join(callable.arguments, ", "));
}

const char* NameOf(int8_t relation) {
  switch (relation) {
    case relation_t::NOT_TOUCHING:
      return "apart";
    case relation_t::TOUCHING:
      return "touching";
    case relation_t::OVERLAPPING:
      return "overlapping";
    default:
      return "absent";
  }
}

std::string StepsOf(const std::vector<plan_step_t>& steps) {
  std::vector<std::string> texts;
  for (const plan_step_t& step : steps) {
    texts.push_back(Call(step, step.action));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The next step, or why there is none.
std::string SummaryOf(const plan_t& plan) {
  if (plan.result == plan_t::GOAL_REACHED) return "the goal is reached";
  if (plan.result == plan_t::UNDECIDED || plan.result == plan_t::NOT_LEARNED) {
    return "no plan yet: " + plan.reason;
  }
  if (plan.result != plan_t::FOUND || plan.steps.empty()) {
    return "no plan leads from here to the goal";
  }
  const plan_step_t& next = plan.steps.front();
  const auto num_left = static_cast<int64_t>(plan.steps.size()) - 1;
  return fmt::format("next: {}, {}", Call(next, next.action),
                     num_left == 0 ? "the last step"
                                   : "then " + Counted(num_left, "more step"));
}

/// "seat PART at SITE"
std::string WordsOf(const asked_skill_t& request) {
  static const std::map<std::string, std::string> kWords = {
      {"insert", "seat"}, {"present", "hand over"}};
  const auto it = kWords.find(request.skill);
  std::string words = it == kWords.end() ? request.skill : it->second;
  std::ranges::replace(words, '_', ' ');
  for (const argument_t& argument : request.arguments) {
    words += (argument.name == "site" ? " at " : " ") + argument.value;
  }
  return words;
}

}  // namespace

std::vector<std::string> Narrator::Describe(const Message& message) {
  if (message.channel == "KEY_FRAME") return DescribeKeyFrame(message);
  if (message.channel == "ACTION") return DescribeAction(message);
  if (message.channel == "PREDICATES") return DescribePredicates(message);
  if (message.channel == "PLAN") return DescribePlan(message);
  if (message.channel == "ALERT") return DescribeAlert(message);
  if (message.channel == "ANSWER") return DescribeAnswer(message);
  if (message.channel == "EPISODE") return DescribeEpisode(message);
  if (message.channel == "SKILL_REQUEST") return DescribeRequest(message);
  if (message.channel == "SKILL_RESULT") return DescribeResult(message);
  if (message.channel == "EXECUTION") return DescribeExecution(message);
  if (message.channel == "MODE") return DescribeMode(message);
  return {};
}

std::vector<std::string> Narrator::DescribeKeyFrame(const Message& message) {
  const auto frame = Decode<key_frame_t>(message);
  if (!frame) return {};
  std::vector<std::string> changes;
  for (const relation_t& r : frame->relations) {
    const auto [it, is_new] =
        relations_.try_emplace({r.first, r.second}, r.relation);
    const bool is_notable =
        is_new ? r.relation != relation_t::NOT_TOUCHING && frame->index > 0
               : it->second != r.relation;
    it->second = r.relation;
    if (is_notable) {
      changes.push_back(
          fmt::format("{} - {} {}", r.first, r.second, NameOf(r.relation)));
    }
  }
  return {Line(frame->header.utime,
               fmt::format("key frame {}: {}", frame->index,
                           changes.empty()
                               ? "no relation changed"
                               : fmt::format("{}", fmt::join(changes, "; "))))};
}

std::vector<std::string> Narrator::DescribeAction(const Message& message) {
  const auto action = Decode<recognised_action_t>(message);
  if (!action) return {};
  std::string what;
  switch (action->kind) {
    case recognised_action_t::FORWARD:
      what = "recognised " + Call(*action, action->name);
      break;
    case recognised_action_t::REVERSED:
      what = "recognised the reverse of " + Call(*action, action->name);
      break;
    default:
      what = "an unknown manipulation of " + action->part;
      if (!action->name.empty()) {
        what += ", learned as " + Call(*action, action->name);
      }
  }
  std::string line =
      fmt::format("{} by {}", what, fmt::join(action->hands, ", "));
  if (is_verbose_)
    line += fmt::format(", confidence {:.2f}", action->confidence);
  return {Line(action->header.utime, line)};
}

std::vector<std::string> Narrator::DescribePredicates(const Message& message) {
  const auto predicates = Decode<predicates_t>(message);
  if (!predicates) return {};
  std::vector<std::string> changes;
  const bool is_first = literals_.empty();
  for (const literal_t& literal : predicates->literals) {
    const std::string name = Call(literal, literal.predicate);
    const auto [it, is_new] = literals_.try_emplace(name, literal.value);
    if (!is_new && it->second == literal.value) continue;
    it->second = literal.value;
    if (is_first && literal.value != literal_t::TRUE_) continue;
    const char* sign = literal.value == literal_t::TRUE_    ? ""
                       : literal.value == literal_t::FALSE_ ? "not "
                                                            : "unknown ";
    changes.push_back(sign + name);
  }
  if (changes.empty() || (is_first && !is_verbose_)) return {};
  return {Continued(fmt::format("{}: {}", is_first ? "state" : "now",
                                fmt::join(changes, ", ")))};
}

std::vector<std::string> Narrator::DescribePlan(const Message& message) {
  const auto plan = Decode<plan_t>(message);
  if (!plan) return {};
  std::vector<std::string> lines;
  const std::string summary = SummaryOf(*plan);
  if (summary != plan_summary_) lines.push_back(Continued(summary));
  plan_summary_ = summary;
  if (is_verbose_ && !plan->reason.empty()) {
    lines.push_back(Continued("because " + plan->reason));
  }
  if (is_verbose_ && plan->result == plan_t::FOUND) {
    lines.push_back(
        Continued(fmt::format("plan, {:.2f} actions expected: {}",
                              plan->expected_actions, StepsOf(plan->steps))));
    lines.push_back(Continued("possible now: " + StepsOf(plan->next)));
  }
  return lines;
}

std::vector<std::string> Narrator::DescribeAlert(const Message& message) {
  const auto alert = Decode<alert_t>(message);
  if (!alert) return {};
  const char* level = alert->level == alert_t::ERROR     ? "ERROR"
                      : alert->level == alert_t::WARNING ? "WARNING"
                                                         : "note";
  return {Line(alert->header.utime, fmt::format("{}: {}", level, alert->text))};
}

std::vector<std::string> Narrator::DescribeAnswer(const Message& message) {
  const auto answer = Decode<answer_t>(message);
  if (!answer) return {};
  const bool is_accepted = answer->outcome == answer_t::ACCEPTED;
  return {
      Line(answer->header.utime,
           fmt::format("{} {}: {}", answer->channel,
                       is_accepted ? "accepted" : "refused", answer->text))};
}

std::vector<std::string> Narrator::DescribeRequest(const Message& message) {
  const auto request = Decode<asked_skill_t>(message);
  if (!request) return {};
  const std::string what =
      fmt::format("the {} arm is to {}", request->arm, WordsOf(*request));
  return {Line(request->header.utime, what)};
}

std::vector<std::string> Narrator::DescribeResult(const Message& message) {
  const auto result = Decode<skill_result_t>(message);
  if (!result) return {};
  const bool is_good = result->outcome == skill_result_t::SUCCEEDED;
  std::string what =
      fmt::format("the {} arm {}", result->arm,
                  is_good ? "succeeded" : "did not succeed: " + result->reason);
  if (result->peak_force > 0) {
    what += fmt::format(" (peak force at its wrist sensor: {:.0f} N)",
                        result->peak_force);
  }
  return {Line(result->header.utime, what)};
}

std::vector<std::string> Narrator::DescribeExecution(const Message& message) {
  const auto execution = Decode<execution_t>(message);
  if (!execution) return {};
  if (execution->state == execution_t::DONE) {
    return {Line(execution->header.utime, "the task is done")};
  }
  if (execution->state == execution_t::STUCK) {
    std::vector<std::string> lines = {
        Line(execution->header.utime, "QUESTION: " + execution->text)};
    if (is_verbose_ && !execution->formula.empty()) {
      lines.push_back(Continued("because " + execution->formula));
    }
    return lines;
  }
  return {};
}

std::vector<std::string> Narrator::DescribeMode(const Message& message) {
  const auto mode = Decode<operating_mode_t>(message);
  if (!mode || mode->reason == hold_reason_) return {};
  hold_reason_ = mode->reason;
  return {Line(mode->header.utime, hold_reason_.empty()
                                       ? "the cell resumes"
                                       : "HOLD: " + hold_reason_)};
}

std::vector<std::string> Narrator::DescribeEpisode(const Message& message) {
  const auto episode = Decode<episode_t>(message);
  if (!episode) return {};
  if (episode->phase == episode_t::RUNNING) return {};
  if (episode->phase == episode_t::END) {
    return {Line(episode->header.utime, "the episode ends")};
  }
  relations_.clear();
  literals_.clear();
  plan_summary_.clear();
  return {
      Line(episode->header.utime,
           fmt::format("episode {}: task {}, goal {}, {} (seed {})",
                       episode->id, episode->task, episode->goal,
                       episode->agent == "robot"
                           ? "the cell does it"
                           : "a person does '" + episode->demonstration + "'",
                       episode->seed))};
}

}  // namespace cell::cli
