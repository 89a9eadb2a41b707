#include "services/cell/evaluations/substitution_evaluation.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell/predicates_t.hpp"
#include "common/bus/decode.h"
#include "common/task/task.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/cell/running/task_variant.h"
#include "services/cell/scoring/episode_observer.h"
#include "services/vtb/script.h"

namespace cell::cli {
namespace {

using nlohmann::json;

/// The script of a variant in which a person places what was never shown.
constexpr char kScript[] = "substitute";

/// The variants that have the script.
std::vector<std::string> VariantsWithScript(
    const std::filesystem::path& task_dir) {
  std::vector<std::string> names = VariantsOf(task_dir);
  std::erase_if(names, [&](const std::string& name) {
    const Config variant =
        Config::Load(task_dir / kVariantsFolder / (name + ".yaml"));
    return !variant.Has("demonstrators.yaml") ||
           !variant["demonstrators.yaml"].Has("scripts") ||
           !variant["demonstrators.yaml"]["scripts"].Has(kScript);
  });
  return names;
}

/// True literals with these arguments, of the last PREDICATES.
class LastPredicates {
 public:
  void Put(const Message& message) {
    if (message.channel != "PREDICATES") return;
    if (auto m = Decode<predicates_t>(message)) last_ = *std::move(m);
  }
  bool HoldsOf(const std::vector<std::string>& arguments) const {
    return std::ranges::any_of(last_.literals, [&](const literal_t& literal) {
      return literal.value == literal_t::TRUE_ &&
             literal.arguments == arguments;
    });
  }

 private:
  predicates_t last_{};
};

/// What the person calls the placement of such a part.
std::string NameOf(const truth_action_t& truth,
                   const vtb::Demonstrations& demonstrations,
                   const PartTable& parts) {
  for (const auto& [name, rule] : demonstrations.rules) {
    if (parts.Find(truth.part)->type == rule.part_type) return rule.called;
  }
  return "";
}

class SubstitutionEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "substitution"; }
  std::string description() const override {
    return "Watch a person place parts that were never shown (the task's "
           "variants).";
  }
  int default_runs() const override { return 50; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const auto variants = VariantsWithScript(deployment.task_dir);
    if (variants.empty()) {
      throw std::runtime_error(deployment.task_dir.string() +
                               ": no variant of the task has a script '" +
                               kScript + "'");
    }
    const std::string& variant = variants[trial.seed % variants.size()];
    const VariedTask varied(deployment, variant);
    EpisodeObserver observer;
    LastPredicates predicates;
    SimBus bus(roster, AllServices(varied.deployment(), kScript, trial.seed));
    RunToEnd(bus, [&](const Message& message) {
      observer.Put(message);
      predicates.Put(message);
    });
    json row = RowOf(observer.record(), predicates, varied.deployment());
    row["variant"] = variant;
    return row;
  }

  RowShape row_shape() const override {
    return RowShape::Counts({"placed", "recognised", "sensed", "actions",
                             "alerts", "steps_before", "steps_after"});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    const char* const group = "substitution";
    return {ShareOf(rows, group, "placements recognised by the part's role",
                    "recognised", "placed"),
            ShareOf(rows, group, "placements whose literal is true then",
                    "sensed", "placed"),
            RunsOf(rows, group,
                   "runs with all recognised, none false, and counted by the "
                   "plan",
                   [](const json& row) {
                     return row.at("placed") > 0 &&
                            row.at("recognised") == row.at("placed") &&
                            row.at("sensed") == row.at("placed") &&
                            row.at("actions") == row.at("placed") &&
                            row.at("alerts") == 0 &&
                            row.at("steps_before").get<int>() ==
                                row.at("steps_after").get<int>() +
                                    row.at("placed").get<int>();
                   })};
  }

 private:
  static json RowOf(const EpisodeRecord& record,
                    const LastPredicates& predicates,
                    const Deployment& deployment) {
    const Task task = LoadTask(deployment);
    const auto demonstrations = vtb::Demonstrations::FromConfig(
        deployment.OfTask("demonstrators.yaml"), task.parts);
    int num_placed = 0, num_recognised = 0, num_sensed = 0;
    for (const truth_action_t& truth : record.truth_actions) {
      if (truth.kind != truth_action_t::PLACED) continue;
      ++num_placed;
      const std::vector<std::string> arguments = {truth.part, truth.site};
      const std::string name = NameOf(truth, demonstrations, task.parts);
      num_recognised += std::ranges::any_of(
          record.actions, [&](const recognised_action_t& action) {
            return action.kind == recognised_action_t::FORWARD &&
                   action.name == name && action.arguments == arguments;
          });
      num_sensed += predicates.HoldsOf(arguments);
    }
    const auto& plans = record.plans;
    return {{"placed", num_placed},
            {"recognised", num_recognised},
            {"sensed", num_sensed},
            {"actions", record.actions.size()},
            {"alerts", record.alerts.size()},
            {"steps_before", plans.empty() ? -1 : plans.front().num_steps},
            {"steps_after", plans.empty() ? -1 : plans.back().num_steps},
            {"seconds", static_cast<double>(record.last_utime) * 1e-6}};
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeSubstitutionEvaluation() {
  return std::make_unique<SubstitutionEvaluation>();
}

}  // namespace cell::cli
