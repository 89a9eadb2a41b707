#include "services/cell/assembly_evaluation.h"

#include <algorithm>
#include <map>
#include <string>

#include "common/bus/sim_bus.h"
#include "services/cell/assembly_observer.h"
#include "services/cell/motion_check.h"
#include "services/cell/row_measures.h"
#include "services/cell/service_registry.h"

namespace cell {
namespace {

using nlohmann::json;

constexpr char kScript[] = "execution";  // of the task's demonstrators.yaml
constexpr char kGroup[] = "assembly";

/// Placements, and parts to be turned home: how many of how many.
void AddScore(const AssemblyScore& score, const PartTable& parts, json* row) {
  const auto num_with_thread = [&](const std::vector<std::string>& sites) {
    return std::ranges::count_if(sites, [&](const std::string& site) {
      return parts.FindThread(parts.FindSite(site)->type) != nullptr;
    });
  };
  const auto turned = num_with_thread(score.seated);
  const auto unturned = num_with_thread(score.missing);
  const auto seated = std::ssize(score.seated) - turned;
  (*row)["placements_seated"] = seated;
  (*row)["placements"] = seated + std::ssize(score.missing) - unturned;
  (*row)["turned_home"] = turned;
  (*row)["turned"] = turned + unturned;
  (*row)["complete"] = score.is_complete();
  (*row)["missing"] = score.missing;
}

void AddRecord(const AssemblyObserver::Record& record, json* row) {
  static const std::map<int, const char*> kStates = {
      {execution_t::RUNNING, "running"},
      {execution_t::DONE, "done"},
      {execution_t::STUCK, "stuck"}};
  const auto& execution = record.execution;
  (*row)["state"] = execution ? kStates.at(execution->state) : "none";
  (*row)["text"] = execution ? execution->text : "";
  (*row)["requests"] = record.num_requests;
  (*row)["refused"] = record.num_refused;
  (*row)["failed"] = record.num_failed;
  (*row)["stopped"] = record.num_stopped;
  (*row)["peak_force"] = record.peak_force;
  (*row)["broken"] = record.broken;
  (*row)["seconds"] = 1e-6 * static_cast<double>(record.last_utime);
}

void AddViolations(const MotionCheck& check, json* row) {
  using Kind = Violation::Kind;
  json& numbers = (*row)["violations"];
  for (const Kind kind : {Kind::kPosition, Kind::kSpeed, Kind::kSetpoint,
                          Kind::kWorkspace, Kind::kCollision}) {
    numbers[NameOf(kind)] =
        std::ranges::count(check.violations(), kind, &Violation::kind);
  }
  json& found = (*row)["found"] = json::array();
  for (const Violation& violation : check.violations()) {
    found.push_back({{"tick", violation.tick},
                     {"arm", violation.arm},
                     {"kind", NameOf(violation.kind)},
                     {"what", violation.what}});
  }
  (*row)["protective_stops"] = check.num_protective_stops();
}

bool HasNo(const json& row, bool is_collision) {
  for (const auto& [kind, num] : row.at("violations").items()) {
    const bool is_of_kind = (kind == "collision") == is_collision;
    if (is_of_kind && num > 0) return false;
  }
  return true;
}

class AssemblyEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "assembly"; }
  std::string description() const override {
    return "Let the arms assemble everything: seated parts, limits, "
           "collisions.";
  }
  int default_runs() const override { return 40; }

  std::vector<Trial> Trials(int runs, uint64_t seed) const override {
    std::vector<Trial> trials;
    for (int i = 0; i < runs; ++i) {
      trials.push_back({kGroup, seed + static_cast<uint64_t>(i)});
    }
    return trials;
  }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& roster) const override {
    const PartTable parts =
        PartTable::FromConfig(deployment.OfTask("parts.yaml"));
    const auto book = DemonstratorBook::FromConfig(
        deployment.OfTask("demonstrators.yaml"), parts);
    AssemblyObserver observer(parts, book);
    MotionCheck check(CellLayout::FromConfig(deployment.OfTask("cell.yaml")),
                      parts);
    SimBus bus(roster, AllServices(deployment, kScript, trial.seed));
    while (bus.Step()) {
      std::vector<Message> messages = bus.last_messages();
      std::sort(messages.begin(), messages.end(), OrderedBefore);
      for (const Message& message : messages) {
        observer.Put(message);
        check.Put(message);
      }
    }
    json row;
    AddScore(observer.Score().value(), parts, &row);
    AddRecord(observer.record(), &row);
    AddViolations(check, &row);
    return row;
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<Measure> measures = {
        RunsOf(rows, kGroup, "runs with all placements seated",
               [](const json& row) {
                 return row.at("placements_seated") == row.at("placements");
               }),
        ShareOf(rows, kGroup, "placements seated", "placements_seated",
                "placements"),
        ShareOf(rows, kGroup, "threaded parts turned home", "turned_home",
                "turned"),
        RunsOf(rows, kGroup, "runs in which nothing seated came loose again",
               [](const json& row) { return row.at("broken").empty(); }),
        RunsOf(rows, kGroup, "runs without a breach of limits",
               [](const json& row) { return HasNo(row, false); }),
        RunsOf(rows, kGroup, "runs without a collision",
               [](const json& row) { return HasNo(row, true); }),
    };
    measures.front().paper = 0.5;
    return measures;
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeAssemblyEvaluation() {
  return std::make_unique<AssemblyEvaluation>();
}

}  // namespace cell
