#include "services/cell/commands/eval_sec.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/goal_table.h"
#include "services/cell/evaluations/sec_classes.h"
#include "services/cell/evaluations/sec_figures.h"
#include "services/cell/evaluations/sec_groups.h"
#include "services/cell/evaluations/sec_statements.h"
#include "services/cell/running/progress.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

struct EvalSecOptions {
  std::string figure;
  int num_classes = 0;
  std::string size = "8x8";
  bool has_equal_roles = false;
  bool is_library = false;
  int samples = 0;
  int orders = 20;
  uint64_t seed = 1;
  std::string out = "runs";
};

// A result file in the folder that --out names; asked for before long work.
fs::path FreeFile(const EvalSecOptions& options, const std::string& name) {
  const fs::path path = fs::path(options.out) / name;
  RequireFree(path, kAnotherOut);
  return path;
}

void WriteResult(const fs::path& path, const std::string& text) {
  WriteNewFile(path, text, kAnotherOut);
  std::cout << "written: " << path.string() << '\n';
}

void DrawPlot(const std::string& program, const fs::path& png) {
  const std::string problem = RunGnuplot(program);
  std::cout << (problem.empty() ? "written: " + png.string() : problem) << '\n';
}

bool PrintGoals(const std::vector<Measure>& measures) {
  std::cout << GoalTable(measures);
  return AreMet(measures);
}

int PrintStatements(const std::string& figure, const std::string& measure,
                    const std::vector<SecCurve>& curves) {
  const auto statements = CheckStatements(figure, measure, curves);
  int num_true = 0;
  std::cout << measure << ":\n";
  for (const SecStatement& s : statements) {
    num_true += s.is_true;
    std::cout << fmt::format("  {:5} {} ({}): {}\n",
                             s.is_true ? "true" : "false", s.text, s.condition,
                             s.found);
  }
  std::cout << fmt::format("  {} of {} statements are true\n", num_true,
                           statements.size());
  return num_true;
}

int RunFigure(const EvalSecOptions& options) {
  const std::string stem =
      fmt::format("sec-figure-{}-seed{}", options.figure, options.seed);
  const fs::path csv = FreeFile(options, stem + ".csv");
  const fs::path png = FreeFile(options, stem + ".png");
  const int samples = options.samples > 0 ? options.samples : 100;
  Progress progress;
  const auto curves =
      MakeSecCurves(options.figure, samples, options.seed,
                    [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  std::cout << fmt::format("Fig. {}: {} samples per level\n", options.figure,
                           samples);
  for (const SecCurve& curve : curves) {
    std::cout << fmt::format("{:10} {:8} {:10}", curve.measure, curve.seed,
                             curve.has_flips ? "with flips" : "no flips");
    for (const SecPoint& point : curve.points) {
      std::cout << fmt::format(" {:3.0f}", 100 * point.mean);
    }
    std::cout << '\n';
  }
  const int paper = PrintStatements(options.figure, "paper", curves);
  const int derivative = PrintStatements(options.figure, "derivative", curves);
  if (paper == derivative) {
    std::cout << "as many of each: this figure does not decide\n";
  } else {
    std::cout << "the reading that agrees better with the paper: "
              << (paper > derivative ? "paper" : "derivative") << '\n';
  }
  const SecDifference difference = LargestDifference(curves);
  std::cout << fmt::format(
      "largest difference from an independent implementation of `paper`: {:.1f}"
      " points ({})\n",
      difference.points, difference.where);
  WriteResult(csv, CurvesToCsv(options.figure, samples, curves));
  DrawPlot(CurvesPlot(options.figure, csv.string(), png.string(), curves), png);
  return 0;
}

// "8x8": rows and columns.
std::optional<std::pair<size_t, size_t>> ParseSize(const std::string& text) {
  unsigned rows = 0, columns = 0;
  int length = 0;
  if (std::sscanf(text.c_str(), "%2ux%2u%n", &rows, &columns, &length) != 2 ||
      static_cast<size_t>(length) != text.size() || rows < 3 || columns < 2) {
    return std::nullopt;
  }
  return std::pair<size_t, size_t>(rows, columns);
}

int RunClasses(const EvalSecOptions& options) {
  const std::string stem = fmt::format(
      "sec-classes-{}-{}{}-seed{}", options.num_classes, options.size,
      options.has_equal_roles ? "-equal-roles" : "", options.seed);
  const fs::path csv = FreeFile(options, stem + ".csv");
  const fs::path roc = FreeFile(options, stem + "-roc.csv");
  const fs::path png = FreeFile(options, stem + ".png");
  const auto size = ParseSize(options.size).value();
  SecClassesParams params;
  params.num_classes = options.num_classes;
  params.num_rows = size.first;
  params.num_columns = size.second;
  params.num_samples = options.samples > 0 ? options.samples : 1000;
  params.seed = options.seed;
  params.has_equal_roles = options.has_equal_roles;
  Progress progress;
  const auto results = ClassifySamples(
      params, [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  std::cout << fmt::format("{:4} {:12} {:>9} {:>17} {:>10}\n", "p", "measure",
                           "right", "95 % interval", "ROC area");
  for (const SecClassesResult& result : results) {
    const auto num_all = static_cast<int>(result.known.size());
    const Interval interval = WilsonInterval(result.num_right(), num_all);
    std::cout << fmt::format(
        "{:.1f}  {:12} {:7.1f} %  {:5.1f} - {:5.1f} % {:10.3f}\n", result.noise,
        result.measure, 100.0 * result.num_right() / num_all,
        100 * interval.low, 100 * interval.high, result.area());
  }
  WriteResult(csv, ClassesToCsv(results));
  WriteResult(roc, RocToCsv(results));
  DrawPlot(ClassesPlot(csv.string(), png.string()), png);
  return PrintGoals(ClassMeasures(results)) ? 0 : 1;
}

int RunLibrary(const EvalSecOptions& options) {
  const fs::path csv =
      FreeFile(options, fmt::format("sec-library-seed{}.csv", options.seed));
  SecGroupsParams params;
  params.num_orders = options.orders;
  params.seed = options.seed;
  if (options.samples > 0) params.num_samples = options.samples;
  Progress progress;
  const auto results = GroupSamples(
      params, [&](const std::string& text) { progress.Show(text); });
  progress.Clear();
  std::cout << GroupsTable(results);
  WriteResult(csv, GroupsToCsv(results));
  std::cout << kImprovedGrouping << ":\n";
  return PrintGoals(GroupMeasures(results)) ? 0 : 1;
}

void AddWhatToMeasure(CLI::App* command, EvalSecOptions* options) {
  auto* what = command->add_option_group("what", "what to measure");
  what->add_option("--figure", options->figure,
                   "curves of this figure, and what the paper says of them")
      ->check(CLI::IsMember(SecFigureNames()));
  what->add_option("--classes", options->num_classes,
                   "classify noisy samples of so many random manipulations")
      ->check(NumberIn(2, 1000));
  what->add_flag("--library", options->is_library,
                 "group samples of five manipulations online");
  what->require_option(1);
}

}  // namespace

void AddEvalSec(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalSecOptions>();
  CLI::App* command = eval.add_subcommand(
      "sec",
      "Measure the similarity of event chains as in section VI-A: the curves "
      "of a figure, the classification of random manipulations, or the online "
      "library. Writes CSV and a plot.\n"
      "Example: cell eval sec --figure 13");
  AddWhatToMeasure(command, options.get());
  command
      ->add_option("--size", options->size,
                   "with --classes: rows x columns of a manipulation")
      ->check([](const std::string& text) {
        return ParseSize(text)
                   ? std::string()
                   : text +
                         " is no size: rows x columns is expected, such as "
                         "8x8, from 3x2 to 99x99";
      })
      ->capture_default_str();
  command->add_flag("--equal-roles", options->has_equal_roles,
                    "with --classes: every manipulation has the same roles");
  command
      ->add_option("--samples", options->samples,
                   "samples per level (default: 100; with --classes 1000), "
                   "with --library per order (150)")
      ->check(NumberIn(2, 1'000'000));
  command
      ->add_option("--orders", options->orders,
                   "with --library: random orders of the samples")
      ->check(NumberIn(1, 100'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of the samples")
      ->check(NumberIn<uint64_t>(0, UINT32_MAX))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for CSV and plot")
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      if (!options->figure.empty()) return RunFigure(*options);
      return options->is_library ? RunLibrary(*options) : RunClasses(*options);
    };
  });
}

}  // namespace cell::cli
