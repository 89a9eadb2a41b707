#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/assemblies/sequence_judge.h"
#include "common/files/draft.h"
#include "common/rules/rule_text.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/annotation_files.h"
#include "services/cell/commands/commands.h"
#include "services/cell/evaluations/mistakes_evaluation.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;
using assemblies::AnnotationFile;
using assemblies::AssemblyAction;
using assemblies::Label;
using assemblies::MistakeKind;
using assemblies::Verdict;

constexpr char kOtherRules[] = "choose another --rules or remove it";
constexpr int kNumProblemsShown = 5;

struct MonitorOptions {
  std::string annotations;
  std::string folder;
  std::string rules_file;
  assemblies::JudgeSettings settings;
};

/// What all sequences of the folder but the judged one teach of its toy.
assemblies::AssemblyModel LearnFrom(const MonitorOptions& options,
                                    const AnnotationFile& judged) {
  std::vector<AnnotationFile> files = LoadAnnotationFolder(options.folder);
  std::vector<assemblies::AssemblySequence> sequences;
  for (AnnotationFile& file : files) {
    const bool is_judged =
        fs::equivalent(file.sequence.file, options.annotations) ||
        fs::path(file.sequence.file).filename() ==
            fs::path(options.annotations).filename();
    if (!is_judged && !file.sequence.toy.empty()) {
      sequences.push_back(std::move(file.sequence));
    }
  }
  const ToySequences toys = GroupByToy(sequences);
  assemblies::OrderPrior others;
  for (const auto& [toy, of_toy] : toys) {
    if (toy != judged.sequence.toy) {
      others.Add(assemblies::CollectEvidence(of_toy));
    }
  }
  const auto own = toys.find(judged.sequence.toy);
  const bool is_known = own != toys.end();
  std::cout << Printable(fmt::format(
                   "toy '{}': learned from {} of it, and {} of other toys",
                   judged.sequence.toy,
                   Counted(
                       is_known ? static_cast<int64_t>(own->second.size()) : 0,
                       "sequence"),
                   sequences.size() - (is_known ? own->second.size() : 0)))
            << "\n";
  if (!is_known) {
    std::cout << "nothing is known of this toy: no attach can be judged\n";
  }
  return LearnModel(is_known ? assemblies::CollectEvidence(own->second)
                             : assemblies::OrderEvidence{},
                    others, options.settings);
}

std::string PlanText(const Verdict& verdict) {
  const int growth = verdict.plan_after - verdict.plan_before;
  if (growth > 0) {
    return fmt::format("; the plan grew by {} to {}", growth,
                       verdict.plan_after);
  }
  return fmt::format("; plan {}", verdict.plan_after);
}

void PrintVerdict(const AssemblyAction& action, const Verdict& verdict) {
  std::string text =
      fmt::format("{:>4}  {} {:<34} {}", action.line, NameOf(action.verb),
                  Show(action.pair), NameOf(verdict.label));
  if (verdict.kind != MistakeKind::kNone) {
    text += fmt::format(" ({})", NameOf(verdict.kind));
  }
  if (!verdict.reason.empty()) text += ": " + verdict.reason;
  text += PlanText(verdict);
  if (action.label && *action.label != verdict.label) {
    const std::string remark = NameOf(action.kind);
    text += fmt::format("  [annotated: {}{}{}]", NameOf(*action.label),
                        remark.empty() ? "" : ", ", remark);
  }
  std::cout << Printable(text) << "\n";
}

int Monitor(MonitorOptions options) {
  if (!options.rules_file.empty()) {
    RequireFree(options.rules_file, kOtherRules);
  }
  const AnnotationFile judged = LoadAnnotations(options.annotations);
  if (judged.sequence.actions.empty()) {
    PrintProblems({judged}, kNumProblemsShown);
    throw std::runtime_error(
        options.annotations +
        ": holds no action; right are rows of first frame, last frame, attach "
        "or detach, part, part, label, remark");
  }
  if (options.folder.empty()) {
    options.folder = fs::absolute(options.annotations).parent_path().string();
  }
  const assemblies::AssemblyModel model = LearnFrom(options, judged);
  assemblies::SequenceJudge judge(model, options.settings);
  int num_agreed = 0;
  int num_labelled = 0;
  for (const AssemblyAction& action : judged.sequence.actions) {
    const Verdict verdict = judge.Judge(action.verb, action.pair);
    PrintVerdict(action, verdict);
    num_labelled += action.label.has_value();
    num_agreed += action.label == verdict.label;
  }
  std::cout << fmt::format(
      "{} to the end of the plan; {} of {} verdicts as annotated\n",
      Counted(judge.PlanLength(), "action"), num_agreed, num_labelled);
  PrintProblems({judged}, kNumProblemsShown);
  if (!options.rules_file.empty()) {
    WriteNewFile(options.rules_file, rules::ToText(model.rules), kOtherRules);
  }
  return 0;
}

}  // namespace

void AddMonitor(CLI::App& app, Action* action) {
  auto options = std::make_shared<MonitorOptions>();
  CLI::App* command = app.add_subcommand(
      "monitor",
      "Judge an annotated assembly action by action, as a person makes it: "
      "correct, mistake or correction, and why. What other people's assemblies "
      "of the same toy require is learned first.\n"
      "Example: cell monitor --annotations annotations/7-b1_9051-c13a_9051.csv "
      "--rules c13a.rules && cell rules show c13a.rules");
  command->add_option("--annotations", options->annotations, "file to judge")
      ->required();
  command->add_option("--learn", options->folder,
                      "folder to learn from (default: the file's own)");
  command->add_option("--rules", options->rules_file,
                      "write the learned rules here");
  command->callback([=] {
    *action = [=] {
      return Monitor(*options);
    };
  });
}

}  // namespace cell::cli
