#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/files/draft.h"
#include "common/rexd/ppddl_import.h"
#include "common/rules/ppddl_export.h"
#include "common/rules/rule_text.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/commands/rules_compare.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_judge.h"
#include "services/cell/commands/rules_learn.h"
#include "services/cell/commands/rules_record.h"

namespace cell::cli {
namespace {

struct RulesOptions {
  std::string file;
  std::string problem;
  std::string out;
  std::string name = "learned";
};

int ShowRules(const RulesOptions& options) {
  std::cout << PrintableLines(RulesToShow(LoadRules(options.file)));
  return 0;
}

int ExportRules(const RulesOptions& options) {
  const auto text = rules::ToPpddl(LoadRules(options.file), options.name);
  if (!text) throw std::runtime_error(options.file + ": " + text.reason());
  if (options.out.empty()) {
    std::cout << PrintableLines(*text);
  } else {
    WriteNewFile(options.out, *text, kAnotherOut);
  }
  return 0;
}

int ImportRules(const RulesOptions& options) {
  const rexd::PpddlText domain{TextOfFile(options.file), options.file};
  const std::string text =
      options.problem.empty()
          ? rexd::RulesOfPpddl(domain)
          : rexd::TaskOfPpddl(domain,
                              {TextOfFile(options.problem), options.problem});
  if (options.out.empty()) {
    std::cout << PrintableLines(text);
  } else {
    WriteNewFile(options.out, text, kAnotherOut);
  }
  return 0;
}

void AddImport(CLI::App* rules, std::shared_ptr<RulesOptions> options,
               Action* action) {
  CLI::App* import = rules->add_subcommand(
      "import",
      "Read a PPDDL domain as rules; with a problem, as a task that REX-D can "
      "learn (cell eval rexd --task-file).\n"
      "Example: cell rules import domain.pddl problem.pddl --out task.rules");
  import->add_option("domain", options->file, "PPDDL domain")->required();
  import->add_option("problem", options->problem, "PPDDL problem");
  import->add_option("--out", options->out, "file (default: print it)");
  import->callback([=] {
    *action = [=] {
      return ImportRules(*options);
};
}  // namespace
);
}  // namespace cell::cli

}  // namespace

void AddRules(CLI::App& app, Action* action) {
  auto options = std::make_shared<RulesOptions>();
  CLI::App* rules = app.add_subcommand(
      "rules",
      "Record experiences; learn, compare, show, import and export noisy "
      "deictic "
      "rules.\n"
      "Example: cell rules learn experiences --out learned.rules");
  rules->require_subcommand(1);
  AddRulesLearn(*rules, action);
  AddRulesRecord(*rules, action);
  AddRulesCompare(*rules, action);
  AddImport(rules, options, action);
  AddRulesJudge(*rules, action);
  CLI::App* show =
      rules->add_subcommand("show",
                            "Show the rules of a file. Done at once: there is "
                            "nothing to resume.\n"
                            "Example: cell rules show learned.rules");
  CLI::App* write = rules->add_subcommand(
      "export",
      "Write the rules of a file as a PPDDL domain. Done at once: there is "
      "nothing to resume.\n"
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
