#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "services/cell/commands/annotation_files.h"
#include "services/cell/commands/commands.h"
#include "services/cell/evaluations/mistakes_evaluation.h"
#include "services/cell/running/progress.h"

namespace cell::cli {
namespace {

using assemblies::JudgeSettings;
using assemblies::Label;

constexpr char kOtherTable[] = "choose another --csv or remove it";
constexpr Label kAllLabels[] = {Label::kCorrect, Label::kMistake,
                                Label::kCorrection};
constexpr double kGoalMacroF1 = 0.74;
constexpr double kGoalMistakeRecall = 0.70;

struct EvalMistakesOptions {
  std::string folder;
  MistakesOptions evaluation;
  std::string csv_file;
  int num_shown = 2;
};

std::string IntervalText(const std::vector<LabelCounts>& groups, uint64_t seed,
                         const std::function<double(const LabelCounts&)>& f) {
  const Interval interval = BootstrapInterval(groups, f, seed);
  return fmt::format("[{:.1f}, {:.1f}]", 100 * interval.low,
                     100 * interval.high);
}

void PrintJudge(const std::string& name, const std::vector<LabelCounts>& groups,
                uint64_t seed) {
  LabelCounts sum;
  for (const LabelCounts& counts : groups) sum.Add(counts);
  std::cout << fmt::format(
      "{:<24} {:5.1f} {:<13} {:8.1f} |", name, 100 * sum.MacroF1(),
      IntervalText(groups, seed, &LabelCounts::MacroF1), 100 * sum.Accuracy());
  for (const Label label : kAllLabels) {
    std::cout << fmt::format(" {:5.1f} ({:5.1f}, {:5.1f})", 100 * sum.F1(label),
                             100 * sum.Precision(label),
                             100 * sum.Recall(label));
  }
  std::cout << "\n";
}

std::string SettingsText(const JudgeSettings& settings) {
  return fmt::format(
      "wrong order from {}, {}, wrong position {}", settings.least_probability,
      settings.builds_on_mistakes ? "builds on mistakes"
                                  : "each attach by itself",
      settings.least_wrong_position > 1
          ? "never"
          : fmt::format("from {}", settings.least_wrong_position));
}

void PrintSettings(const MistakesResult& result, bool is_nested) {
  std::cout << (is_nested
                    ? "\nsettings, chosen for the toys of each fold by the "
                      "others\n"
                    : "\nsettings (defaults)\n");
  for (size_t i = 0; i < result.chosen.size(); ++i) {
    std::cout << fmt::format("  {}: {}\n", i + 1,
                             SettingsText(result.chosen[i]));
  }
}

void PrintKinds(const MistakesResult& result) {
  std::cout << fmt::format("\n{:<42} {:>8} {:>8} {:>10} {:>10}\n",
                           "annotated / verdict", "correct", "mistake",
                           "correction", "same kind");
  for (const auto& [name, row] : result.kinds) {
    std::cout << fmt::format("{:<42}", name);
    for (const Label label : kAllLabels) {
      const auto it = row.verdicts.find(label);
      std::cout << fmt::format(" {:>{}}",
                               it == row.verdicts.end() ? 0 : it->second,
                               label == Label::kCorrection ? 10 : 8);
    }
    std::cout << fmt::format(" {:>10}\n", row.num_same_kind);
  }
}

std::string CsvOf(const MistakesResult& result) {
  std::string text =
      "toy,sequences,actions,macro_f1,least_probability,builds_on_mistakes,"
      "least_wrong_position";
  for (const Label label : kAllLabels) {
    for (const Label verdict : kAllLabels) {
      text += fmt::format(",{}_as_{}", NameOf(label), NameOf(verdict));
    }
  }
  text += "\n";
  for (const auto& [toy, row] : result.toys) {
    text += fmt::format("{},{},{},{:.4f},{},{},{}", toy, row.num_sequences,
                        row.num_actions, row.counts.MacroF1(),
                        row.settings.least_probability,
                        row.settings.builds_on_mistakes ? 1 : 0,
                        row.settings.least_wrong_position);
    for (const Label label : kAllLabels) {
      for (const Label verdict : kAllLabels) {
        text += fmt::format(",{}", row.counts.At(label, verdict));
      }
    }
    text += "\n";
  }
  return text;
}

/// True if the goals are met.
bool PrintResult(const MistakesResult& result,
                 const EvalMistakesOptions& options) {
  std::vector<LabelCounts> groups;
  LabelCounts sum;
  for (const auto& [toy, row] : result.toys) {
    groups.push_back(row.counts);
    sum.Add(row.counts);
  }
  const uint64_t seed = options.evaluation.seed;
  std::cout << fmt::format(
      "{} toys, {} splits, {:.0f} judged actions, seed {}; percent; 95 % "
      "intervals by bootstrap over toys\n\n"
      "{:<24} {:>5} {:<13} {:>8} | F1 (precision, recall) of correct, mistake, "
      "correction\n",
      result.toys.size(), options.evaluation.num_splits, sum.num_all(), seed,
      "", "F1", "", "accuracy");
  PrintJudge("learned rules", groups, seed);
  for (size_t k = 0; k < kNumControls; ++k) {
    std::vector<LabelCounts> controls;
    for (const auto& [toy, row] : result.toys) {
      controls.push_back(row.controls[k]);
    }
    PrintJudge(NameOf(static_cast<Control>(k)), controls, seed);
  }
  PrintSettings(result, options.evaluation.is_nested);
  PrintKinds(result);
  const double f1 = sum.MacroF1();
  const double recall = sum.Recall(Label::kMistake);
  const auto met = [](double value, double goal) {
    return value >= goal ? "met" : "NOT met";
  };
  std::cout << fmt::format("\nmacro F1 {:.1f} {}, goal {:.0f}: {}\n", 100 * f1,
                           IntervalText(groups, seed, &LabelCounts::MacroF1),
                           100 * kGoalMacroF1, met(f1, kGoalMacroF1));
  std::cout << fmt::format(
      "recall of mistakes {:.1f} {}, goal {:.0f}: {}\n", 100 * recall,
      IntervalText(
          groups, seed,
          [](const LabelCounts& c) { return c.Recall(Label::kMistake); }),
      100 * kGoalMistakeRecall, met(recall, kGoalMistakeRecall));
  if (result.num_unlabelled > 0) {
    std::cout << fmt::format("{} judged actions without a label: not scored\n",
                             result.num_unlabelled);
  }
  return f1 >= kGoalMacroF1 && recall >= kGoalMistakeRecall;
}

int EvalMistakes(const EvalMistakesOptions& options) {
  if (!options.csv_file.empty()) RequireFree(options.csv_file, kOtherTable);
  Progress progress;
  progress.Show("reading " + options.folder);
  const auto files = LoadAnnotationFolder(options.folder);
  std::vector<assemblies::AssemblySequence> sequences;
  for (const auto& file : files) {
    if (!file.sequence.toy.empty() && !file.sequence.actions.empty()) {
      sequences.push_back(file.sequence);
    }
  }
  const MistakesResult result =
      EvaluateMistakes(GroupByToy(sequences), options.evaluation,
                       [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  if (result.toys.empty()) {
    PrintProblems(files, options.num_shown);
    throw std::runtime_error(options.folder +
                             ": no toy has two sequences: one to judge and one "
                             "to learn from");
  }
  const bool is_met = PrintResult(result, options);
  PrintProblems(files, options.num_shown);
  if (!options.csv_file.empty()) {
    WriteNewFile(options.csv_file, CsvOf(result), kOtherTable);
  }
  return is_met ? 0 : 1;
}

}  // namespace

void AddEvalMistakes(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalMistakesOptions>();
  CLI::App* command = eval.add_subcommand(
      "mistakes",
      "Judge people's assemblies online: which actions are mistakes and which "
      "are corrections, by rules learned from other people's. Reads a folder "
      "of annotations *.csv: first frame, last frame, attach or detach, part, "
      "part, correct or mistake or correction, remark; the toy is in the file "
      "name, ..._ACTOR-TOY_....csv.\n"
      "Example: cell eval mistakes annotations --csv toys.csv");
  command->add_option("folder", options->folder, "folder of annotations")
      ->required();
  command
      ->add_option("--splits", options->evaluation.num_splits,
                   "times that one sequence of each toy is drawn and judged")
      ->check(NumberIn(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--folds", options->evaluation.num_folds,
                   "groups of toys whose settings the other groups choose")
      ->check(NumberIn(2, 1000))
      ->capture_default_str();
  command->add_flag("!--no-nested", options->evaluation.is_nested,
                    "take the default settings instead of choosing them");
  command->add_option("--seed", options->evaluation.seed, "of splits and folds")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  command
      ->add_option("--problems", options->num_shown,
                   "odd lines of each kind that are shown")
      ->check(NumberIn(0, 1'000'000))
      ->capture_default_str();
  command->add_option("--csv", options->csv_file,
                      "write the counts of each toy here");
  command->callback([=] {
    *action = [=] {
      return EvalMistakes(*options);
    };
  });
}

}  // namespace cell::cli
