#include "services/cell/evaluations/rexd_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "services/cell/scoring/interval.h"

namespace cell::cli {

using nlohmann::json;
namespace {

constexpr const char* kBlockCounts[] = {"actions", "demonstrations",
                                        "explorations"};
constexpr const char* kKnowledge[] = {kCarriedOver, kFromScratch};

RexdGroup With(const char* knowledge, const RexdGroup& group) {
  RexdGroup part{group.success, {}};
  for (const json& row : group.rows) part.rows.push_back(row.at(knowledge));
  return part;
}

std::string CountsText(const RexdGroup& group, int first, int last) {
  std::string text;
  for (const char* count : kBlockCounts) {
    const MeanAndSd s = SummariseCount(group, count, first, last);
    text += fmt::format("  {} {:5.1f} (sd {:.1f})", count, s.mean, s.sd);
  }
  const double reached = SummariseCount(group, "reached", first, last).mean;
  return text + fmt::format("  goal reached {:.1f} %\n",
                            100 * reached / (last - first + 1));
}

int SumOf(const json& row, const char* knowledge, int first, int last) {
  int sum = 0;
  for (int i = first; i <= last; ++i) {
    sum += row.at(knowledge)
               .at("demonstrations")
               .at(static_cast<size_t>(i))
               .get<int>();
  }
  return sum;
}

/// Demonstrations of a block from scratch less those that are needed if
/// learning carries over, run by run.
struct PairedDifference {
  double mean = 0;
  double margin = 0;  ///< of its 95 % interval
};

PairedDifference SavedIn(const RexdGroup& group, int first, int last) {
  PairedDifference saved;
  const double n = static_cast<double>(group.rows.size());
  std::vector<double> differences;
  for (const json& row : group.rows) {
    differences.push_back(SumOf(row, kFromScratch, first, last) -
                          SumOf(row, kCarriedOver, first, last));
    saved.mean += differences.back() / n;
  }
  double square = 0;
  for (const double d : differences) {
    square += (d - saved.mean) * (d - saved.mean);
  }
  if (n > 1) saved.margin = 1.96 * std::sqrt(square / (n - 1) / n);
  return saved;
}

}  // namespace

RowShape BlocksRowShape(const BlockPlan& plan) {
  const RowShape numbers = RowShape::ListOf(
      RowShape::kWhole,
      static_cast<size_t>(plan.num_blocks() * plan.num_episodes));
  RowShape::Fields counts{{"reached", numbers}};
  for (const char* count : kBlockCounts) counts.emplace(count, numbers);
  RowShape::Fields fields;
  for (const char* knowledge : kKnowledge) {
    fields.emplace(knowledge, RowShape::Record(counts));
  }
  return RowShape::Record(fields);
}

std::string BlocksText(const BlockPlan& plan, const RexdGroup& group) {
  std::string text;
  for (int block = 0; block < plan.num_blocks(); ++block) {
    const int first = block * plan.num_episodes;
    const int last = first + plan.num_episodes - 1;
    const double floor = plan.floors[static_cast<size_t>(block)];
    text += fmt::format("  {} (at least {:.1f} actions an episode)\n",
                        plan.names[static_cast<size_t>(block)],
                        floor / group.success);
    for (const char* knowledge : kKnowledge) {
      const RexdGroup part = With(knowledge, group);
      for (int i = first; i <= last; ++i) {
        text += fmt::format("    {}, episode {:>3}:{}", knowledge, i + 1,
                            CountsText(part, i, i));
      }
      text += fmt::format("    {}, in all     :{}", knowledge,
                          CountsText(part, first, last));
    }
  }
  return text;
}

std::string BlocksCsv(const BlockPlan& plan,
                      const std::vector<RexdGroup>& groups) {
  std::string csv = "success,knowledge,block,episode";
  for (const char* count : kBlockCounts) {
    csv += fmt::format(",{0},{0}_sd", count);
  }
  csv += ",goal_reached\n";
  for (const RexdGroup& group : groups) {
    for (const char* knowledge : kKnowledge) {
      const RexdGroup part = With(knowledge, group);
      for (int i = 0; i < plan.num_blocks() * plan.num_episodes; ++i) {
        csv += fmt::format(
            "{},{},{},{}", group.success, knowledge,
            plan.names[static_cast<size_t>(i / plan.num_episodes)], i + 1);
        for (const char* count : kBlockCounts) {
          const MeanAndSd s = SummariseCount(part, count, i, i);
          csv += fmt::format(",{},{}", s.mean, s.sd);
        }
        csv += fmt::format(",{}\n", SummariseCount(part, "reached", i, i).mean);
      }
    }
  }
  return csv;
}

std::string BlocksPlot(const BlockPlan& plan,
                       const std::vector<RexdGroup>& groups,
                       const std::string& csv, const std::string& png) {
  const int num_episodes = plan.num_blocks() * plan.num_episodes;
  std::string text = fmt::format(
      "set terminal pngcairo size 1100,1100\nset output '{}'\n"
      "set datafile sep ','\nset multiplot layout 3,1\n"
      "set xrange [0.5:{}.5]\nset yrange [0:]\nset xtics 1\nset grid\n"
      "set key outside\nset xlabel 'episode'\n",
      png, num_episodes);
  for (int block = 1; block < plan.num_blocks(); ++block) {
    text += fmt::format(
        "set arrow from {0}.5, graph 0 to {0}.5, graph 1 nohead dt 2\n",
        block * plan.num_episodes);
  }
  int column = 5;
  for (const char* count : kBlockCounts) {
    text += fmt::format("set ylabel '{}'\nplot ", count);
    int line = 0;
    for (const RexdGroup& group : groups) {
      for (const char* knowledge : kKnowledge) {
        const int first = 1 + line * num_episodes;
        text += fmt::format(
            "{}'{}' every ::{}::{} using ($4+{:.2f}):{}:{} with yerrorlines "
            "title 'success {}, {}'",
            line > 0 ? ", " : "", csv, first, first + num_episodes - 1,
            0.06 * line, column, column + 1, group.success, knowledge);
        ++line;
      }
    }
    text += "\n";
    column += 2;
  }
  return text + "unset multiplot\n";
}

std::vector<RexdStatement> CheckBlockStatements(const BlockPlan& plan,
                                                const RexdGroup& group) {
  std::vector<RexdStatement> statements;
  const RexdGroup carried = With(kCarriedOver, group);
  const RexdGroup scratch = With(kFromScratch, group);
  for (int block = 1; block < plan.num_blocks(); ++block) {
    const std::string& name = plan.names[static_cast<size_t>(block)];
    const int first = block * plan.num_episodes;
    const int last = first + plan.num_episodes - 1;
    const PairedDifference saved = SavedIn(group, first, last);
    const MeanAndSd needed =
        SummariseCount(carried, "demonstrations", first, last);
    statements.push_back(
        {name + ": fewer demonstrations than from scratch",
         fmt::format(
             "{:.2f} instead of {:.2f}, {:.2f} +- {:.2f} fewer", needed.mean,
             SummariseCount(scratch, "demonstrations", first, last).mean,
             saved.mean, saved.margin),
         saved.mean - saved.margin > 0});
    const auto num_runs = static_cast<int>(group.rows.size());
    const auto num_one = static_cast<int>(
        std::ranges::count_if(group.rows, [&](const json& row) {
          return SumOf(row, kCarriedOver, first, last) <= 1;
        }));
    const Interval interval = WilsonInterval(num_one, num_runs);
    statements.push_back(
        {name + ": at most one demonstration is left to ask for",
         fmt::format("in {} of {} runs ({:.1f} - {:.1f} %), {:.2f} in the mean",
                     num_one, num_runs, 100 * interval.low, 100 * interval.high,
                     needed.mean),
         num_one == num_runs});
  }
  return statements;
}

}  // namespace cell::cli
