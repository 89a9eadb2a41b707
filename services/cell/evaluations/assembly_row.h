#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "common/bus/roster.h"
#include "common/bus/sim_bus.h"
#include "common/config/deployment.h"
#include "common/parts/part_table.h"
#include "services/cell/evaluations/row_shape.h"
#include "services/cell/scoring/assembly_observer.h"
#include "services/cell/scoring/motion_check.h"

namespace cell::cli {

/// The script of the task's demonstrators.yaml in which the arms assemble.
inline constexpr char kExecutionScript[] = "execution";

/// A row of an evaluation: one assembly by the cell in one process, scored by
/// the ground truth at its end, its motions checked on the way. `script`: of
/// the task's demonstrators.yaml. `intervene`: called before the run; its
/// result receives every message and may schedule outages of services.
/// `goal`: by which the end is scored; empty: that of success.yaml.
using Intervention =
    std::function<std::function<void(const Message&)>(SimBus& bus)>;
nlohmann::json RunAssembly(const std::string& script, uint64_t seed,
                           const Deployment& deployment, const Roster& roster,
                           const Intervention& intervene = {},
                           const std::string& goal = "");

/// The parts that a text is about. A site, such as host.hole, is a word of its
/// own and does not name its host.
std::set<std::string> PartsNamedIn(std::string text, const PartTable& parts);

/// What such a row says of an assembly that was observed and checked.
/// @pre there were enough poses for a score.
nlohmann::json AssemblyRow(const AssemblyObserver& observer,
                           const MotionCheck& check, const PartTable& parts);

/// Of such a row.
RowShape AssemblyRowShape();

/// True if the motions of the row's run kept all limits.
bool HasKeptLimits(const nlohmann::json& row);
bool HasHitNothing(const nlohmann::json& row);

}  // namespace cell::cli
