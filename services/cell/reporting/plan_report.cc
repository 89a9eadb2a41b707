#include "services/cell/reporting/plan_report.h"

#include <fmt/format.h>

#include "common/text/counted.h"
#include "services/cell/scoring/interval.h"

namespace cell::cli {
namespace {

using nlohmann::json;
using planning::Plan;

constexpr size_t kMaxAlternatives = 12;  // shown in the text

json ToJson(const planning::Interval& interval) {
  return {interval.low, interval.high};
}

json ToJson(const planning::Rollouts& rollouts) {
  const Interval interval =
      WilsonInterval(rollouts.num_reached, rollouts.num_runs);
  return {{"runs", rollouts.num_runs},
          {"reached", rollouts.num_reached},
          {"interval", {interval.low, interval.high}},
          {"mean_actions", rollouts.mean_actions}};
}

std::string ProbabilityText(const planning::Interval& probability) {
  return fmt::format("{:.9g}, proven to lie in [{:.9g}, {:.9g}]",
                     probability.low, probability.low, probability.high);
}

std::string CourseText(const Plan& plan) {
  std::string text = "most likely course:\n";
  for (size_t i = 0; i < plan.course.size(); ++i) {
    text += fmt::format("{:4}  {:40} {:.4g}\n", i + 1, plan.course[i].name,
                        plan.course[i].probability);
  }
  return text;
}

std::string AlternativesText(const Plan& plan) {
  std::string text = "first actions, and the goal's probability after each:\n";
  for (size_t i = 0; i < plan.alternatives.size(); ++i) {
    if (i == kMaxAlternatives) {
      return text +
             fmt::format("      and {} more\n", plan.alternatives.size() - i);
    }
    const planning::Alternative& alternative = plan.alternatives[i];
    text +=
        fmt::format("      {:40} [{:.6g}, {:.6g}]\n", alternative.name,
                    alternative.probability.low, alternative.probability.high);
  }
  return text;
}

std::string RolloutsText(const planning::Rollouts& rollouts) {
  const Interval interval =
      WilsonInterval(rollouts.num_reached, rollouts.num_runs);
  return fmt::format(
      "executed: goal reached in {} of {}, 95 % interval [{:.4f}, {:.4f}], "
      "{:.3f} actions on average\n",
      rollouts.num_reached, Counted(rollouts.num_runs, "run"), interval.low,
      interval.high, rollouts.mean_actions);
}

std::string ExcusesText(const PlanReport& report) {
  if (report.excuses.empty()) return "";
  std::string text = "a plan would be possible otherwise:\n";
  for (const std::string& excuse : report.excuses) {
    std::string lines = "  - " + excuse + "\n";
    for (size_t at = 0; (at = lines.find('\n', at)) + 1 < lines.size();) {
      lines.insert(++at, "    ");
    }
    text += lines;
  }
  if (report.subgoals.empty()) return text;
  text += "what can be done meanwhile:\n";
  for (const std::string& subgoal : report.subgoals) {
    text += "  - " + subgoal + "\n";
  }
  return text;
}

}  // namespace

std::string ToText(Plan::Status status) {
  switch (status) {
    case Plan::Status::kFound:
      return "found";
    case Plan::Status::kGoalReached:
      return "goal reached";
    case Plan::Status::kNoPlan:
      return "no plan";
    case Plan::Status::kUndecided:
      break;
  }
  return "undecided";
}

std::string ToText(const PlanReport& report) {
  const Plan& plan = report.plan;
  std::string text = fmt::format("{} of {}: plan {}\n", report.problem,
                                 report.domain, ToText(plan.status));
  if (!plan.reason.empty()) text += "reason: " + plan.reason + "\n";
  if (plan.status == Plan::Status::kFound) {
    text += "probability: " + ProbabilityText(plan.probability) + "\n";
    text += fmt::format("expected actions: {:.9g}, {}\n", plan.expected_actions,
                        plan.is_shortest
                            ? "proven the fewest of the most probable plans"
                            : "not proven to be the fewest (see --fewest)");
    text += CourseText(plan) + AlternativesText(plan);
  } else if (plan.status == Plan::Status::kUndecided) {
    text += "probability: " + ProbabilityText(plan.probability) + "\n";
  }
  text += ExcusesText(report);
  if (report.rollouts) text += RolloutsText(*report.rollouts);
  return text + fmt::format("{}, {}, {:.1f} MB; {:.1f} MB at most in all\n",
                            Counted(plan.num_expansions, "expansion"),
                            Counted(plan.num_states, "state"),
                            static_cast<double>(plan.num_bytes) * 1e-6,
                            static_cast<double>(report.peak_bytes) * 1e-6);
}

json ToJson(const PlanReport& report) {
  const Plan& plan = report.plan;
  json course = json::array();
  for (const planning::Step& step : plan.course) {
    course.push_back(
        {{"action", step.name}, {"probability", step.probability}});
  }
  json alternatives = json::array();
  for (const planning::Alternative& alternative : plan.alternatives) {
    alternatives.push_back({{"action", alternative.name},
                            {"interval", ToJson(alternative.probability)}});
  }
  json excuses = json::array();
  for (size_t i = 0; i < report.excuses.size(); ++i) {
    excuses.push_back(
        {{"text", report.excuses[i]}, {"changes", report.changes[i]}});
  }
  return {{"domain", report.domain},
          {"problem", report.problem},
          {"status", ToText(plan.status)},
          {"reason", plan.reason},
          {"probability", plan.probability.low},
          {"interval", ToJson(plan.probability)},
          {"expected_actions", plan.expected_actions},
          {"is_shortest", plan.is_shortest},
          {"plan", course},
          {"alternatives", alternatives},
          {"excuses", excuses},
          {"subgoals", report.subgoals},
          {"rollouts", report.rollouts ? ToJson(*report.rollouts) : json()},
          {"expansions", plan.num_expansions},
          {"states", plan.num_states},
          {"memory_bytes", plan.num_bytes},
          {"peak_memory_bytes", report.peak_bytes}};
}

}  // namespace cell::cli
