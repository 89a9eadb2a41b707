#include "services/cell/commands/rules_learn.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "common/rules/learning/learner.h"
#include "common/rules/rule_error.h"
#include "common/rules/rule_text.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/row_files.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/commands/rules_options.h"
#include "services/cell/evaluations/missing_runs.h"
#include "services/cell/evaluations/row_store.h"

namespace cell::cli {
namespace {

using nlohmann::json;

struct RulesLearnOptions {
  std::string data;
  std::string symbols;
  std::string out;
  std::string rows_file;  // empty: none
  bool is_resumed = false;
  int jobs = 1;
  rules::LearnerOptions learner;
};

struct Learned {
  rules::NdrRules rules;
  double score = 0;
};

Learned LearnFrom(const std::vector<rules::Experience>& experiences,
                  const rules::ExperienceSet& set,
                  const rules::LearnerOptions& options) {
  rules::Learner learner(set.world, options);
  for (const rules::Experience& e : experiences) learner.Add(e);
  learner.Learn();
  return {learner.Rules(), learner.Score()};
}

using ByAction = std::map<int, std::vector<rules::Experience>>;

/// The key of a row is its action.
RowIdentity IdentityOf(const RulesLearnOptions& options) {
  RowIdentity identity{"rules learn", OptionTexts(options.learner), {}};
  identity.options["--seed"] = std::to_string(options.learner.seed);
  AddExperiences(FilesOfExperiences(options.data, options.symbols), &identity);
  return identity;
}

/// Adds the rules of a row, and its score.
void AddRow(const RowStore& store, const std::string& key, Learned* all) {
  const auto text = store.At(key).at("rules").get<std::string>();
  rules::NdrRules part{all->rules.symbols, {}};
  try {
    for (auto& [line, rule] :
         rules::ParseRulesOf(part.symbols, text, "rules")) {
      part.rules.push_back(std::move(rule));
    }
  } catch (const rules::RuleError& e) {
    store.FailAt(key, e.what());
  }
  if (rules::ToText(part) != text) {
    store.FailAt(key, "rules: should be symbols and rules as --out has them");
  }
  std::ranges::move(part.rules, std::back_inserter(all->rules.rules));
  all->score += store.At(key).at("score").get<double>();
}

/// Action by action, each kept as a row: actions are learned from apart.
Learned LearnInRows(const RulesLearnOptions& options,
                    const rules::ExperienceSet& set) {
  ByAction by_action;
  for (const rules::Experience& e : set.experiences) {
    by_action[e.act.action].push_back(e);
  }
  const std::vector<ByAction::value_type> parts(by_action.begin(),
                                                by_action.end());
  std::vector<std::string> keys;
  for (const auto& part : parts) {
    keys.push_back(set.world->symbols()[part.first].name);
  }
  RowStore store({.path = options.rows_file,
                  .is_resumed = options.is_resumed,
                  .identity = IdentityOf(options),
                  .shape = RowShape::Record({{"rules", RowShape::kText},
                                             {"score", RowShape::kNumber}})});
  const auto learn = [&](size_t i) -> json {
    const Learned part = LearnFrom(parts[i].second, set, options.learner);
    return {{"rules", rules::ToText(part.rules)}, {"score", part.score}};
  };
  DoMissingRuns(keys, options.jobs, learn, &store);
  Learned all{{set.world->shared_symbols(), {}}, 0};
  for (const std::string& key : keys) {
    if (!store.Has(key)) {
      throw std::runtime_error(
          "not all actions were learned; repeat the "
          "command with --resume");
    }
    AddRow(store, key, &all);
  }
  return all;
}

int LearnRules(const RulesLearnOptions& options) {
  RequireDistinct({options.out, options.rows_file});
  if (!options.out.empty()) RequireFree(options.out, kAnotherOut);
  const rules::ExperienceSet set =
      LoadExperiences(options.data, options.symbols);
  const Learned learned = options.rows_file.empty()
                              ? LearnFrom(set.experiences, set, options.learner)
                              : LearnInRows(options, set);
  std::cout << fmt::format(
      "{}, {}, score {:.3f}\n",
      Counted(static_cast<int64_t>(set.experiences.size()), "experience"),
      Counted(static_cast<int64_t>(learned.rules.rules.size()), "rule"),
      learned.score);
  std::cout << PrintableLines(RulesToShow(learned.rules));
  if (!options.out.empty()) {
    WriteNewFile(options.out, rules::ToText(learned.rules), kAnotherOut);
  }
  return 0;
}

}  // namespace

std::string RulesToShow(const rules::NdrRules& rules) {
  std::string text;
  for (const rules::Rule& rule : rules.rules) {
    text += "\n" + rules::ToText(rule, *rules.symbols, 2);
  }
  return text;
}

void AddRulesLearn(CLI::App& rules, Action* action) {
  auto options = std::make_shared<RulesLearnOptions>();
  CLI::App* learn = rules.add_subcommand(
      "learn",
      "Learn noisy deictic rules from experiences: a folder with data.dat "
      "(states and actions in turn) and symbols.dat (their symbols).\n"
      "Example: cell rules learn experiences --out learned.rules\n"
      "Example: cell rules learn experiences --rows learned.jsonl --resume");
  learn->add_option("data", options->data, "folder, or file of experiences")
      ->required();
  learn->add_option("--symbols", options->symbols,
                    "file of symbols (default: symbols.dat beside the data)");
  learn->add_option("--out", options->out, "write symbols and rules here");
  CLI::Option* rows = learn->add_option(
      "--rows", options->rows_file,
      "keep the rules of each action here as they are learned, so that "
      "learning that is interrupted can go on");
  learn
      ->add_flag("--resume", options->is_resumed,
                 "take the rules of an earlier call with the same experiences "
                 "and options from there, and learn those of the other "
                 "actions")
      ->needs(rows);
  learn
      ->add_option("--jobs", options->jobs,
                   "number of processes at a time, with --rows")
      ->check(NumberIn(1, 256))
      ->capture_default_str();
  AddLearnerOptions(learn, &options->learner);
  learn->callback([=] {
    *action = [=] {
      return LearnRules(*options);
    };
  });
}

}  // namespace cell::cli
