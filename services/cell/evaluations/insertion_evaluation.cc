#include "services/cell/evaluations/insertion_evaluation.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include "cell/asked_skill_t.hpp"
#include "common/bus/decode.h"
#include "common/task/task.h"
#include "services/cell/evaluations/assembly_row.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/evaluations/skill_driver.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/cell/scoring/assembly_observer.h"
#include "services/robot_arm/robot_arm.h"
#include "services/vtb/script.h"

namespace cell::cli {

using namespace vtb;

using namespace robot_arm;
namespace {

using nlohmann::json;

constexpr char kSearch[] = "search", kNoSearch[] = "no_search";
constexpr double kAimOffset = 0.002;                  // [m]
constexpr double kAimAngle = std::numbers::pi / 180;  // [rad]

struct Bench {
  explicit Bench(const Deployment& deployment)
      : task(LoadTask(deployment)),
        demonstrations(Demonstrations::FromConfig(
            deployment.OfTask("demonstrators.yaml"), task.parts)) {}
  Task task;
  Demonstrations demonstrations;
};

/// Those that can be tried alone: nothing must be in place before. Each with
/// the part that goes there.
std::vector<SkillDriver::Task> Insertions(const Bench& bench) {
  std::vector<SkillDriver::Task> tasks;
  for (const auto& [name, rule] : bench.demonstrations.rules) {
    if (!rule.after.empty()) continue;
    const auto part = std::ranges::find(bench.task.parts.parts(),
                                        rule.part_type, &Part::type);
    for (const Part& host : bench.task.parts.parts()) {
      for (const Site& site : host.sites) {
        if (site.type != rule.site_type) continue;
        tasks.push_back(
            {"", "insert", {{"part", part->name}, {"site", site.name}}});
      }
    }
  }
  if (tasks.empty())
    throw std::runtime_error(
        "no insertion is possible without another before it");
  return tasks;
}

SkillDriver::Params DriverFor(const Bench& bench, uint64_t seed) {
  const auto insertions = Insertions(bench);
  SkillDriver::Params params;
  params.tasks = {insertions[seed % insertions.size()]};
  for (const ArmLayout& arm : bench.task.layout.arms) {
    (arm.X_FS ? params.tasks.front().arm : params.helper) = arm.name;
  }
  return params;
}

/// Testbed, tracker and arms, with a driver instead of those that decide.
Roster RosterOf(const Roster& whole) {
  Roster roster;
  roster.task = whole.task;
  for (const auto& entry : whole.entries) {
    if (entry.name == "vtb" || entry.name == "tracker" ||
        entry.name == "motion_planner" ||
        entry.name.starts_with("robot_arm@")) {
      roster.entries.push_back(entry);
    }
  }
  roster.entries.push_back({.name = "driver", .feeds_clock = true});
  return roster;
}

std::map<std::string, ServiceFactory> Services(
    const Deployment& deployment, const Bench& bench, const Trial& trial,
    const SkillDriver::Params& driver) {
  auto services = AllServices(deployment, kExecutionScript, trial.seed);
  services["driver"] = [driver](Bus& bus) {
    return std::make_unique<SkillDriver>(bus, driver);
  };
  SkillSettings settings = SkillSettings::FromConfig(
      deployment.OfTask("skills.yaml"), bench.task.parts);
  settings.aim_error = {kAimOffset, kAimAngle, trial.seed};
  if (trial.group == kNoSearch) {
    for (auto& [type, insertion] : settings.insertions) {
      insertion.contact.search.max_spirals = 0;
    }
  }
  for (const ArmLayout& arm : bench.task.layout.arms) {
    const RobotArm::Params params{
        {arm.name, bench.task.layout, bench.task.parts, settings},
        bench.task.scene_objects};
    services["robot_arm@" + arm.name] = [params](Bus& bus) {
      return std::make_unique<RobotArm>(bus, params);
    };
  }
  return services;
}

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const size_t half = values.size() / 2;
  return values.size() % 2 ? values[half]
                           : (values[half - 1] + values[half]) / 2;
}

class InsertionEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "insertion"; }
  std::string description() const override {
    return "Insert single parts with an aim that is off by 2 mm and 1 degree.";
  }
  int default_runs() const override { return 20; }

  std::vector<TrialGroup> groups() const override {
    return {{kSearch}, {kNoSearch}};
  }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const Bench bench(deployment);
    const SkillDriver::Params driver = DriverFor(bench, trial.seed);
    const auto success = SuccessCriterion::Load(deployment);
    AssemblyObserver observer(success);
    std::optional<skill_result_t> result;
    SimBus bus(RosterOf(roster), Services(deployment, bench, trial, driver));
    RunToEnd(bus, [&](const Message& message) {
      observer.Put(message);
      if (message.channel == "SKILL_RESULT") {
        result = Decode<skill_result_t>(message);
      }
    });
    const SkillDriver::Task& task = driver.tasks.front();
    const Eigen::Isometry3d X_SE =
        AimError{kAimOffset, kAimAngle, trial.seed}.Of(result ? result->id : 0);
    const AssemblyScore score = observer.Score().value();
    return {
        {"part", task.arguments.at("part")},
        {"site", task.arguments.at("site")},
        {"seated",
         std::ranges::count(score.seated, task.arguments.at("site")) > 0},
        {"succeeded", result && result->outcome == skill_result_t::SUCCEEDED},
        {"reason", result ? result->reason : "no result"},
        {"requests", observer.record().num_requests},
        {"peak_force", observer.record().peak_force},
        {"aim_error_mm", 1e3 * X_SE.translation().norm()},
        {"aim_error_deg",
         Eigen::AngleAxisd(X_SE.linear()).angle() * 180 / std::numbers::pi},
        {"seconds", 1e-6 * static_cast<double>(observer.record().last_utime)}};
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    return RowShape::Record(
        {{"seated", kFlag}, {"succeeded", kFlag}, {"peak_force", kNumber}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    const auto is_inserted = [](const json& row) {
      return row.at("seated").get<bool>() && row.at("succeeded").get<bool>();
    };
    std::vector<Measure> measures = {
        RunsOf(rows, kSearch, "parts seated, and reported as seated",
               is_inserted),
        RunsOf(rows, kNoSearch, "parts seated, and reported as seated",
               is_inserted),
    };
    measures.back().goal = 0;  // for comparison
    return measures;
  }

  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    std::vector<Figure> figures;
    for (const char* group : {kSearch, kNoSearch}) {
      std::vector<double> forces;
      for (const json& row : rows) {
        if (row.at("group") == group) forces.push_back(row.at("peak_force"));
      }
      if (forces.empty()) continue;
      const std::string of = std::string(group) + ": peak force, ";
      figures.push_back({of + "median", Median(forces), "N"});
      figures.push_back({of + "highest", std::ranges::max(forces), "N"});
    }
    return figures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeInsertionEvaluation() {
  return std::make_unique<InsertionEvaluation>();
}

}  // namespace cell::cli
