#include "services/cell/commands/rexd_trials.h"

#include <fmt/format.h>

#include <utility>

#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {

RexdTrialRows RunTrials(
    const EvalRexdOptions& options, const RowIdentity& identity,
    const RowShape& shape,
    const std::function<nlohmann::json(const RexdTrial&)>& run) {
  const std::vector<RexdTrial> trials = TrialsOf(options);
  RowStore store({.path = RowsFile(options),
                  .is_resumed = options.is_resumed,
                  .identity = identity,
                  .shape = shape});
  std::vector<std::string> keys;
  for (const RexdTrial& trial : trials) keys.push_back(trial.Key());
  DoMissingRuns(
      keys, options.jobs, [&](size_t i) { return run(trials[i]); }, &store);
  RexdTrialRows rows{{}, 0, trials.size(), store.path()};
  for (const double success : options.successes) {
    std::vector<std::string> of_group;
    for (const RexdTrial& trial : trials) {
      if (trial.success == success) of_group.push_back(trial.Key());
    }
    RexdGroup group{success, store.RowsOf(of_group)};
    rows.num_rows += group.rows.size();
    if (!group.rows.empty()) rows.groups.push_back(std::move(group));
  }
  return rows;
}

std::string ToText(const RexdTrialRows& rows) {
  return fmt::format("rows in {} ({} of {} runs)\n", rows.file.string(),
                     rows.num_rows, rows.num_trials);
}

}  // namespace cell::cli
