#include "services/cell/commands/rules_record.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/experiences/experience_text.h"
#include "common/files/draft.h"
#include "common/text/counted.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

constexpr char kFreeOut[] = "choose another --out or remove it";

struct RecordOptions {
  std::vector<std::string> runs;
  std::string out;
};

int RecordExperiences(const RecordOptions& options) {
  RequireFree(options.out, kFreeOut);
  std::string text;
  std::map<std::string, int64_t> counts;
  for (const std::string& path : options.runs) {
    const RunFolder run = RunFolder::Open(path);
    const RuleWorld world = RuleWorldOf(LoadTask(run.deployment).domain);
    const auto experiences = ExperiencesOfRun(run, world);
    for (const rules::Experience& experience : experiences) {
      ++counts[world.world()->symbols()[experience.act.action].name];
    }
    text += fmt::format("# {}, seed {}\n", run.demonstration, run.seed) +
            ToText(experiences, world);
  }
  WriteNewFile(options.out, text, kFreeOut);
  for (const auto& [action, number] : counts) {
    std::cout << fmt::format("{}: {}\n", action, Counted(number, "experience"));
  }
  std::cout << fmt::format("{}: {} bytes\n", options.out, text.size());
  return 0;
}

}  // namespace

void AddRulesRecord(CLI::App& rules, Action* action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = rules.add_subcommand(
      "record",
      "Write the experiences of runs as text, to learn rules from: the state "
      "as sensed before and after each recognised action, and each skill that "
      "failed.\n"
      "Example: cell rules record runs/sim-0001 --out seen.experiences");
  command->add_option("runs", options->runs, "run folders")->required();
  command->add_option("--out", options->out, "file to create")->required();
  command->callback([=] {
    *action = [=] {
      return RecordExperiences(*options);
    };
  });
}

}  // namespace cell::cli
