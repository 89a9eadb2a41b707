#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/files/draft.h"
#include "common/rules/learning/learner.h"
#include "common/rules/ppddl_export.h"
#include "common/rules/rule_text.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/rules_compare.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_judge.h"
#include "services/cell/commands/rules_options.h"
#include "services/cell/commands/rules_record.h"

namespace cell::cli {
namespace {

constexpr char kAnotherFile[] = "choose another --out or remove it";

struct RulesOptions {
  std::string data;
  std::string symbols;
  std::string file;
  std::string out;
  std::string name = "learned";
  rules::LearnerOptions learner;
};

void PrintRules(const rules::NdrRules& rules) {
  std::string text;
  for (const rules::Rule& rule : rules.rules) {
    text += "\n" + rules::ToText(rule, *rules.symbols, 2);
  }
  std::cout << PrintableLines(text);
}

int LearnRules(const RulesOptions& options) {
  if (!options.out.empty()) RequireFree(options.out, kAnotherFile);
  const rules::ExperienceSet set =
      LoadExperiences(options.data, options.symbols);
  rules::Learner learner(set.world, options.learner);
  for (const rules::Experience& experience : set.experiences) {
    learner.Add(experience);
  }
  learner.Learn();
  const rules::NdrRules rules = learner.Rules();
  std::cout << fmt::format(
      "{}, {}, score {:.3f}\n",
      Counted(static_cast<int64_t>(set.experiences.size()), "experience"),
      Counted(static_cast<int64_t>(rules.rules.size()), "rule"),
      learner.Score());
  PrintRules(rules);
  if (!options.out.empty()) {
    WriteNewFile(options.out, rules::ToText(rules), kAnotherFile);
  }
  return 0;
}

int ShowRules(const RulesOptions& options) {
  PrintRules(LoadRules(options.file));
  return 0;
}

int ExportRules(const RulesOptions& options) {
  const auto text = rules::ToPpddl(LoadRules(options.file), options.name);
  if (!text) throw std::runtime_error(options.file + ": " + text.reason());
  if (options.out.empty()) {
    std::cout << PrintableLines(*text);
  } else {
    WriteNewFile(options.out, *text, kAnotherFile);
  }
  return 0;
}

void AddLearn(CLI::App* rules, std::shared_ptr<RulesOptions> options,
              Action* action) {
  CLI::App* learn = rules->add_subcommand(
      "learn",
      "Learn noisy deictic rules from experiences: a folder with data.dat "
      "(states and actions in turn) and symbols.dat (their symbols).\n"
      "Example: cell rules learn experiences --out learned.rules");
  learn->add_option("data", options->data, "folder, or file of experiences")
      ->required();
  learn->add_option("--symbols", options->symbols,
                    "file of symbols (default: symbols.dat beside the data)");
  learn->add_option("--out", options->out, "write symbols and rules here");
  AddLearnerOptions(learn, &options->learner);
  learn->callback([=] {
    *action = [=] {
      return LearnRules(*options);
    };
  });
}

}  // namespace

void AddRules(CLI::App& app, Action* action) {
  auto options = std::make_shared<RulesOptions>();
  CLI::App* rules = app.add_subcommand(
      "rules",
      "Record experiences; learn, compare, show and export noisy deictic "
      "rules.\n"
      "Example: cell rules learn experiences --out learned.rules");
  rules->require_subcommand(1);
  AddLearn(rules, options, action);
  AddRulesRecord(*rules, action);
  AddRulesJudge(*rules, action);
  AddRulesCompare(*rules, action);
  CLI::App* show =
      rules->add_subcommand("show",
                            "Show the rules of a file.\n"
                            "Example: cell rules show learned.rules");
  CLI::App* write = rules->add_subcommand(
      "export",
      "Write the rules of a file as a PPDDL domain.\n"
      "Example: cell rules export learned.rules --out learned.ppddl");
  for (CLI::App* command : {show, write}) {
    command->add_option("file", options->file, "file of rules")->required();
  }
  write->add_option("--out", options->out, "file (default: print it)");
  write->add_option("--name", options->name, "name of the domain")
      ->capture_default_str();
  show->callback([=] {
    *action = [=] {
      return ShowRules(*options);
    };
  });
  write->callback([=] {
    *action = [=] {
      return ExportRules(*options);
    };
  });
}

}  // namespace cell::cli
