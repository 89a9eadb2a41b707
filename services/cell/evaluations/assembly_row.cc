#include "services/cell/evaluations/assembly_row.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

#include "common/task/task.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"
#include "services/cell/scoring/assembly_observer.h"
#include "services/cell/scoring/motion_check.h"

namespace cell::cli {

namespace {

using nlohmann::json;

/// Parts seated and parts tightened, each of how many.
void AddScore(const AssemblyScore& score, const PartTable& parts, json* row) {
  const auto num_with_thread = [&](const std::vector<std::string>& sites) {
    return std::ranges::count_if(sites, [&](const std::string& site) {
      return IsThreaded(site, parts);
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
  if (!record.unattended.empty()) {
    (*row)["state"] = "held";
    (*row)["text"] = record.unattended;
  }
  (*row)["requests"] = record.num_requests;
  (*row)["refused"] = record.num_refused;
  (*row)["failed"] = record.num_failed;
  (*row)["stopped"] = record.num_stopped;
  (*row)["yielded"] = record.num_yielded;
  (*row)["peak_force"] = record.peak_force;
  (*row)["broken"] = record.broken;
  (*row)["seconds"] = 1e-6 * static_cast<double>(record.last_utime);
}

/// Parts that a person touched, and parts that the cell's last message names.
void AddParts(const AssemblyObserver::Record& record, const PartTable& parts,
              json* row) {
  (*row)["touched"] = record.touched;
  (*row)["named"] =
      PartsNamedIn(record.execution ? record.execution->text : "", parts);
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

}  // namespace

std::set<std::string> PartsNamedIn(std::string text, const PartTable& parts) {
  std::ranges::replace_if(
      text, [](char c) { return !std::isalnum(c) && c != '_' && c != '.'; },
      ' ');
  std::istringstream words(text);
  std::set<std::string> named;
  for (std::string word; words >> word;) {
    word.erase(word.find_last_not_of('.') + 1);
    if (parts.Find(word) != nullptr) named.insert(word);
  }
  return named;
}

json RunAssembly(const std::string& script, uint64_t seed,
                 const Deployment& deployment, const Roster& roster,
                 const Intervention& intervene, const std::string& goal) {
  const Task task = LoadTask(deployment);
  auto success = SuccessCriterion::FromConfig(deployment.OfTask("success.yaml"),
                                              task.domain, task.parts);
  if (!goal.empty()) {
    success = success.ForGoal(*task.domain.FindGoal(goal));
  }
  AssemblyObserver observer(success);
  MotionCheck check(task.layout, task.parts);
  SimBus bus(roster, AllServices(deployment, script, seed));
  const auto also = intervene ? intervene(bus) : nullptr;
  RunToEnd(bus, [&](const Message& message) {
    observer.Put(message);
    check.Put(message);
    if (also) also(message);
  });
  return AssemblyRow(observer, check, task.parts);
}

json AssemblyRow(const AssemblyObserver& observer, const MotionCheck& check,
                 const PartTable& parts) {
  json row;
  AddScore(observer.Score().value(), parts, &row);
  AddRecord(observer.record(), &row);
  AddParts(observer.record(), parts, &row);
  AddViolations(check, &row);
  return row;
}

RowShape AssemblyRowShape() {
  using enum RowShape::Kind;
  const RowShape names = RowShape::ListOf(kText);
  const RowShape counts = RowShape::MapOf(kWhole);
  return RowShape::Counts({"placements_seated", "placements", "turned_home",
                           "turned", "requests", "failed"})
      .With({{"complete", kFlag},
             {"state", kText},
             {"broken", names},
             {"touched", names},
             {"named", names},
             {"violations",
              counts.With({{NameOf(Violation::Kind::kCollision), kWhole}})}});
}

bool HasKeptLimits(const json& row) {
  for (const auto& [kind, num] : row.at("violations").items()) {
    if (kind != NameOf(Violation::Kind::kCollision) && num > 0) return false;
  }
  return true;
}

bool HasHitNothing(const json& row) {
  return row.at("violations").at(NameOf(Violation::Kind::kCollision)) == 0;
}

}  // namespace cell::cli
