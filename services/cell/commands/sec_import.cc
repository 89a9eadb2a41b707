#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/node/number_option.h"
#include "common/sec/chain_similarities.h"
#include "common/text/counted.h"
#include "services/cell/commands/sec_commands.h"
#include "services/cell/evaluations/sec_recordings.h"
#include "services/cell/scoring/interval.h"

namespace cell::cli {
namespace {

struct ImportOptions {
  std::vector<std::string> files;
  double threshold = 0.5;
  std::string measure = "typed";
  bool shows_chains = false;
};

const std::vector<std::string>& ImportMeasures() {
  static const std::vector<std::string> names = [] {
    auto measures = ChainSimilarityNames();
    measures.push_back("size");
    return measures;
  }();
  return names;
}

int NumRight(const std::vector<SecLeftOut>& results) {
  return static_cast<int>(
      std::ranges::count_if(results, &SecLeftOut::is_right));
}

void PrintRecordings(const std::vector<SecRecording>& recordings,
                     const std::vector<SecLeftOut>& results,
                     bool shows_chains) {
  std::cout << fmt::format("{:16} {:>9}  {:12} {:16} {}\n", "recording", "size",
                           "is read as", "most similar", "similarity");
  for (size_t i = 0; i < recordings.size(); ++i) {
    const auto& [name, label, chain] = recordings[i];
    const SecLeftOut& result = results[i];
    std::cout << fmt::format(
        "{:16} {:>9}  {:12} {:16} {:.3f}{}\n", name,
        fmt::format("{}x{}", chain.num_rows(), chain.num_columns()),
        result.label.empty() ? "(a tie)" : result.label, result.nearest,
        result.similarity, result.is_right ? "" : "  wrong");
    if (shows_chains) std::cout << ToText(chain);
  }
}

// The accuracy of every measure at several thresholds of touching.
void PrintThresholds(const ImportOptions& options) {
  std::cout << fmt::format("\n{:>12}", "threshold");
  for (const auto& measure : ImportMeasures()) {
    std::cout << fmt::format(" {:>10}", measure);
  }
  std::cout << '\n';
  std::set<double> thresholds = {0.1, 0.2, 0.3, 0.4, 0.5,
                                 0.6, 0.7, 0.8, 0.9, options.threshold};
  for (const double threshold : thresholds) {
    std::string line = fmt::format("{:11.2f}{}", threshold,
                                   threshold == options.threshold ? "*" : " ");
    try {
      const auto recordings = ReadRecordings(options.files, threshold);
      for (const auto& measure : ImportMeasures()) {
        line += fmt::format(
            " {:>10}",
            fmt::format("{}/{}",
                        NumRight(ClassifyLeaveOneOut(recordings, measure)),
                        recordings.size()));
      }
    } catch (const std::invalid_argument& error) {
      line += std::string(" ") + error.what();
    }
    std::cout << line << '\n';
  }
}

int Import(const ImportOptions& options) {
  const auto recordings = ReadRecordings(options.files, options.threshold);
  if (recordings.size() == 1) {
    std::cout << ToText(recordings.front().chain);
    return 0;
  }
  const auto results = ClassifyLeaveOneOut(recordings, options.measure);
  PrintRecordings(recordings, results, options.shows_chains);
  const int num_right = NumRight(results);
  const auto num_all = static_cast<int>(results.size());
  const Interval interval = WilsonInterval(num_right, num_all);
  std::cout << fmt::format(
      "{} of {} right, each left out ({}, relations from {}): {:.0f} % "
      "({:.0f} - {:.0f} %)\n",
      num_right, num_all, options.measure, options.threshold,
      100.0 * num_right / num_all, 100 * interval.low, 100 * interval.high);
  PrintThresholds(options);
  return 0;
}

}  // namespace

void AddSecImport(CLI::App& sec, Action* action) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = sec.add_subcommand(
      "import",
      "Read relations over time (CSV: 'frame', then a column for each pair, a "
      "number from 0 to 1 for touching, 2 overlapping, 9 absent) into event "
      "chains, and classify each by the others. A file's name up to the last "
      "'_' is its manipulation. Of one file, show the chain.\n"
      "Example: cell sec import pour_01.csv pour_02.csv stir_01.csv");
  command->add_option("files", options->files, "tables of relations")
      ->required();
  command
      ->add_option("--threshold", options->threshold,
                   "number from which on two objects touch")
      ->check(NumberIn(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--measure", options->measure, "similarity of chains")
      ->check(CLI::IsMember(ImportMeasures()))
      ->capture_default_str();
  command->add_flag("--chains", options->shows_chains, "show each chain");
  command->callback([=] {
    *action = [=] {
      return Import(*options);
    };
  });
}

}  // namespace cell::cli
