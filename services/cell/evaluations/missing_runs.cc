#include "services/cell/evaluations/missing_runs.h"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "common/node/run_service.h"
#include "services/cell/evaluations/job_pool.h"
#include "services/cell/running/progress.h"

namespace cell::cli {

using nlohmann::json;

void DoMissingRuns(const std::vector<std::string>& keys, int num_processes,
                   const std::function<json(size_t)>& run, RowStore* rows) {
  std::vector<size_t> missing;
  for (size_t i = 0; i < keys.size(); ++i) {
    if (!rows->Has(keys[i])) missing.push_back(i);
  }
  Progress progress;
  size_t num_done = 0;
  const auto& stop = StopOnSignals();
  const auto show_and_go_on = [&] {
    progress.Show(fmt::format("{}/{} runs, {:.0f} s", num_done, missing.size(),
                              progress.ElapsedSeconds()));
    return !stop;
  };
  show_and_go_on();
  RunJobs(
      missing, num_processes, [&](size_t i) { return run(i).dump(); },
      [&](size_t i, const std::string& result) {
        ++num_done;
        const json row = json::parse(result, nullptr, false);
        if (row.is_object()) {
          rows->Append(keys[i], row);
        } else {
          progress.Clear();
          std::cerr << keys[i] << ": no result\n";
        }
      },
      show_and_go_on);
  if (!stop) return;
  throw std::runtime_error(
      fmt::format("stopped; {} of {} runs are in {}: repeat the command with "
                  "--resume to run the others",
                  keys.size() - missing.size() + num_done, keys.size(),
                  rows->path().string()));
}

}  // namespace cell::cli
