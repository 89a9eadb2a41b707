#include "services/cell/commands/eval_rexd_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "common/node/cell_files.h"
#include "services/cell/commands/rules_files.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kRules[] = ".rules";

bool IsWithout(const EvalRexdOptions& options, const char* part) {
  return std::ranges::find(options.without, part) != options.without.end();
}

fs::path LearningFolder(const EvalRexdOptions& options) {
  return FindCellFiles(options.deploy_dir).deployment.task_dir / "learning";
}

fs::path FindBlock(const EvalRexdOptions& options, const std::string& block) {
  if (fs::is_regular_file(block)) return block;
  const fs::path shipped = LearningFolder(options) / (block + kRules);
  if (fs::is_regular_file(shipped)) return shipped;
  throw std::runtime_error(
      fmt::format("--blocks: there is neither a file '{}' nor {}", block,
                  shipped.string()));
}

}  // namespace

std::string RexdTrial::Key() const {
  return fmt::format("{}/{}", success, seed);
}

std::vector<RexdTrial> TrialsOf(const EvalRexdOptions& options) {
  std::vector<RexdTrial> trials;
  for (const double success : options.successes) {
    for (int i = 0; i < options.runs; ++i) {
      trials.push_back({success, options.seed + static_cast<uint64_t>(i)});
    }
  }
  return trials;
}

rexd::RunParams ParamsOf(const EvalRexdOptions& options,
                         const RexdTrial& trial) {
  rexd::RunParams params;
  params.success = trial.success;
  params.seed = trial.seed;
  params.num_episodes = options.episodes;
  params.teacher.is_sure = options.teacher == "sure";
  params.teacher.heeds_guidance = !IsWithout(options, "guidance");
  params.learner.uses_subgoals = !IsWithout(options, "subgoals");
  if (IsWithout(options, "alternatives")) params.learner.max_alternatives = 0;
  params.learner.explores_no_ops = options.explores_no_ops;
  return params;
}

std::string RowsFile(const EvalRexdOptions& options) {
  if (!options.rows_file.empty()) return options.rows_file;
  std::string name = "runs/eval-rexd-" + options.teacher;
  if (!options.task_file.empty()) {
    name += "-" + fs::path(options.task_file).stem().string();
  }
  for (const std::string& block : options.blocks) {
    name += "-" + NameOfBlock(block);
  }
  for (const std::string& part : options.without) name += "-without-" + part;
  if (!options.explores_no_ops) name += "-skip-no-ops";
  return fmt::format("{}-seed{}.jsonl", name, options.seed);
}

RowIdentity IdentityOf(const EvalRexdOptions& options) {
  const std::set<std::string> without(options.without.begin(),
                                      options.without.end());
  std::vector<std::string> blocks;
  for (const std::string& block : options.blocks) {
    blocks.push_back(NameOfBlock(block));
  }
  const auto listed = [](const auto& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
  };
  return {"eval rexd",
          {{"--teacher", options.teacher},
           {"--without", listed(without)},
           {"--skip-no-ops", options.explores_no_ops ? "no" : "yes"},
           {"--episodes", std::to_string(options.episodes)},
           {"--blocks", listed(blocks)}},
          {}};
}

rexd::RexdTask LoadRexdTask(const EvalRexdOptions& options,
                            RowIdentity* identity) {
  const char* shipped =
      options.blocks.empty() ? "placements.rules" : "changed_tasks.rules";
  const fs::path path = options.task_file.empty()
                            ? LearningFolder(options) / shipped
                            : fs::path(options.task_file);
  const std::string text = TextOfFile(path);
  identity->AddFile("the task file", text);
  rexd::RexdTask task = rexd::ParseRexdTask(text, path.string());
  if (IsWithout(options, "fits")) task = rexd::WithoutPredicate(task, "fits");
  if (IsWithout(options, "types")) task = rexd::WithoutTypes(task);
  return task;
}

std::vector<rexd::RexdTask> LoadBlocks(const EvalRexdOptions& options,
                                       RowIdentity* identity) {
  const rexd::RexdTask task = LoadRexdTask(options, identity);
  std::vector<rexd::RexdTask> blocks;
  for (const std::string& block : options.blocks) {
    const fs::path file = FindBlock(options, block);
    const std::string text = TextOfFile(file);
    identity->AddFile(fmt::format("the file of block {}", blocks.size() + 1),
                      text);
    blocks.push_back(rexd::ParseChangedTask(task, text, file.string()));
  }
  return blocks;
}

std::string NameOfBlock(const std::string& file) {
  return fs::path(file).stem().string();
}

}  // namespace cell::cli
