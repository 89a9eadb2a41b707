#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <iostream>
#include <memory>

#include "common/files/draft.h"
#include "common/node/number_option.h"
#include "services/cell/commands/commands.h"
#include "services/cell/evaluations/gnuplot.h"
#include "services/cell/evaluations/growth.h"

namespace cell::cli {
namespace {

constexpr char kAnotherGrowth[] = "choose another --csv or remove it";

struct EvalGrowthOptions {
  std::vector<int> objects = {5, 10, 15, 20, 30, 40, 50};
  std::vector<int> experiences = {10, 30, 100, 300, 1000, 3000, 10000, 100000};
  int num_experiences = 300;  // while objects grow
  int num_objects = 10;       // while experiences grow
  int64_t max_expansions = 20'000;
  double seconds = 60;
  uint64_t seed = 1;
  std::string csv_file;
};

std::vector<GrowthSeries> MeasureAll(const EvalGrowthOptions& options) {
  const Stopwatch now = [] {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  };
  const auto measure = [&](const GrowthSeries& series,
                           const std::vector<int>& sizes,
                           const std::function<double(int)>& run) {
    return MeasureGrowth(series, sizes, options.seconds, now, run);
  };
  return {measure({"planning", "objects", "expansions", {}}, options.objects,
                  [&](int n) { return PlanTree(n, options.max_expansions); }),
          measure({fmt::format("learning from {} experiences",
                               options.num_experiences),
                   "objects",
                   "score",
                   {}},
                  options.objects,
                  [&](int n) {
                    return LearnTree(n, options.num_experiences, options.seed);
                  }),
          measure({fmt::format("learning with {} objects", options.num_objects),
                   "experiences",
                   "score",
                   {}},
                  options.experiences, [&](int n) {
                    return LearnTree(options.num_objects, n, options.seed);
                  })};
}

int EvalGrowth(const EvalGrowthOptions& options) {
  const std::string png = PictureOf(options.csv_file);
  if (!options.csv_file.empty()) {
    RequireFree(options.csv_file, kAnotherGrowth);
    RequireFree(png, kAnotherGrowth);
  }
  const std::vector<GrowthSeries> all = MeasureAll(options);
  std::cout << GrowthText(all);
  if (options.csv_file.empty()) return 0;
  std::cout << WritePlottedTable(options.csv_file, GrowthCsv(all),
                                 GrowthPlot(all, options.csv_file, png),
                                 kAnotherGrowth);
  return 0;
}

}  // namespace

void AddEvalGrowth(CLI::App& eval, Action* action) {
  auto options = std::make_shared<EvalGrowthOptions>();
  CLI::App* command = eval.add_subcommand(
      "growth",
      "How long planning and learning take, in seconds of the processor, as "
      "objects and experiences grow: an "
      "assembly of parts of which each rests on another one, two on each, and "
      "comes to rest in nine of ten cases.\n"
      "Example: cell eval growth --csv growth.csv");
  command->add_option("--objects", options->objects, "numbers of objects")
      ->delimiter(',')
      ->check(NumberIn(2, 1000))
      ->capture_default_str();
  command
      ->add_option("--experiences", options->experiences,
                   "numbers of experiences, with --among objects")
      ->delimiter(',')
      ->check(NumberIn(1, 10'000'000))
      ->capture_default_str();
  command
      ->add_option("--from", options->num_experiences,
                   "experiences to learn from while objects grow")
      ->check(NumberIn(1, 10'000'000))
      ->capture_default_str();
  command
      ->add_option("--among", options->num_objects,
                   "objects while experiences grow")
      ->check(NumberIn(2, 1000))
      ->capture_default_str();
  command
      ->add_option("--max-expansions", options->max_expansions,
                   "states whose successors are computed at most for a plan")
      ->check(NumberIn<int64_t>(1))
      ->capture_default_str();
  command
      ->add_option("--seconds", options->seconds,
                   "a series ends after a size that took longer")
      ->check(NumberIn<double>(0.001, 1e6))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "seed of the experiences")
      ->check(NumberIn<uint64_t>())
      ->capture_default_str();
  command->add_option("--csv", options->csv_file,
                      "write the table here, and FILE.png that plots it");
  command->callback([=] {
    *action = [=] {
      return EvalGrowth(*options);
    };
  });
}

}  // namespace cell::cli
