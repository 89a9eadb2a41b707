#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/rexd/rexd_run.h"
#include "services/cell/evaluations/row_identity.h"

namespace cell::cli {

/// What `cell eval rexd` is asked for, apart from the curve of --ppddl.
struct EvalRexdOptions {
  std::string deploy_dir;
  std::string task_file;
  std::vector<std::string> blocks;  ///< files of changed tasks, in turn
  std::vector<double> successes = {1, 0.8, 0.6, 0.4};
  std::string teacher = "sure";
  std::vector<std::string> without;
  bool explores_no_ops = true;
  int runs = 100;
  int episodes = 4;  ///< of each block, if there are any
  uint64_t seed = 1;
  int jobs = 2;
  std::string rows_file;
  std::string csv_file;
  bool is_resumed = false;
};

/// One run of the evaluation.
struct RexdTrial {
  double success;
  uint64_t seed;
  std::string Key() const;
};

inline constexpr char kAnotherTable[] = "choose another --csv or remove it";

/// All success rates with the same seeds.
std::vector<RexdTrial> TrialsOf(const EvalRexdOptions& options);
rexd::RunParams ParamsOf(const EvalRexdOptions& options,
                         const RexdTrial& trial);
/// Where rows go if nothing else is said: names the task and everything that
/// changes a run.
std::string RowsFile(const EvalRexdOptions& options);

/// Of the rows: the options that change one but what RexdTrial::Key() says. The
/// files are added as they are loaded.
RowIdentity IdentityOf(const EvalRexdOptions& options);

/// The file of the options, or else the task's, which is added to `identity`.
/// @throws RuleError, std::runtime_error naming the file
rexd::RexdTask LoadRexdTask(const EvalRexdOptions& options,
                            RowIdentity* identity);
/// The tasks of the blocks, whose files are added to `identity`, too. One that
/// is no file is looked for in learning/ of the task.
/// @throws RuleError, std::runtime_error naming the file
std::vector<rexd::RexdTask> LoadBlocks(const EvalRexdOptions& options,
                                       RowIdentity* identity);
/// "NAME" of "learning/NAME.rules".
std::string NameOfBlock(const std::string& file);

}  // namespace cell::cli
