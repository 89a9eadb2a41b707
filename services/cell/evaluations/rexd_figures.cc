#include "services/cell/evaluations/rexd_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "services/cell/scoring/interval.h"

namespace cell::cli {

using nlohmann::json;
namespace {

constexpr const char* kCounts[] = {"actions", "demonstrations", "explorations"};

/// How the learned probabilities of one action compare with the true rate.
struct RateCheck {
  int num_runs = 0;
  int num_inside = 0;
  double sum = 0;
};

/// True if a rate seen in so many trials lies where 95 % of them do.
bool IsInside(double seen, double rate, double num_trials) {
  const double sd = std::sqrt(rate * (1 - rate) / num_trials);
  return std::abs(seen - rate) <= 1.96 * sd + 0.5 / num_trials;
}

std::map<std::string, RateCheck> CheckRates(const RexdGroup& group) {
  std::map<std::string, RateCheck> checks;
  for (const json& row : group.rows) {
    for (const auto& [action, value] : row.at("probabilities").items()) {
      const double p = value.at(0);
      const double num_trials = value.at(1);
      RateCheck& check = checks[action];
      if (num_trials <= 0) continue;
      ++check.num_runs;
      check.num_inside += IsInside(p, group.success, num_trials);
      check.sum += p;
    }
  }
  return checks;
}

std::string RatesText(const RexdGroup& group) {
  std::string text;
  for (const auto& [action, check] : CheckRates(group)) {
    if (check.num_runs == 0) continue;
    text += fmt::format(
        "  {}: success {:.3f} in the mean; inside the 95 % interval of the "
        "true rate in {:.1f} % of {} runs\n",
        action, check.sum / check.num_runs,
        100.0 * check.num_inside / check.num_runs, check.num_runs);
  }
  return text;
}

std::string FrozenText(const RexdGroup& group) {
  int num_states = 0;
  int num_valid = 0;
  for (const json& row : group.rows) {
    num_states += row.at("states").get<int>();
    num_valid += row.at("valid").get<int>();
  }
  if (num_states == 0) return "";
  return fmt::format(
      "  frozen rules: the first action is right in {:.2f} % of the reachable "
      "states ({} of {})\n",
      100.0 * num_valid / num_states, num_valid, num_states);
}

/// Falls of the robot in one run; of the teacher's nothing can be learned that
/// the robot should do otherwise.
struct Falls {
  std::set<int> kinds;  ///< true rules of the actions that led to a dead end
  bool is_repeated = false;  ///< by a rule that had led to one before
};

Falls FallsOf(const json& row) {
  Falls falls;
  const auto rules = row.value("fatal_rules", std::vector<int>());
  const auto is_shown = row.value("shown_falls", std::vector<int>());
  for (size_t i = 0; i < rules.size(); ++i) {
    if (rules[i] < 0 || is_shown.at(i) != 0) continue;
    falls.is_repeated |= !falls.kinds.insert(rules[i]).second;
  }
  return falls;
}

std::string DeadEndsText(const RexdGroup& group) {
  int num_fallen = 0;
  int num_repeated = 0;
  int num_others = 0;
  for (const json& row : group.rows) {
    const Falls falls = FallsOf(row);
    num_fallen += !falls.kinds.empty();
    num_repeated += falls.is_repeated;
    num_others += falls.kinds.size() > 1;
  }
  if (num_fallen == 0) return "";
  const Interval interval = WilsonInterval(num_repeated, num_fallen);
  return fmt::format(
      "  dead ends: the robot's action led to one in {} runs, in {} of these "
      "to "
      "another one later by the same kind of action ({:.1f} - {:.1f} %), in {} "
      "by another kind\n",
      num_fallen, num_repeated, 100 * interval.low, 100 * interval.high,
      num_others);
}

}  // namespace

MeanAndSd SummariseCount(const RexdGroup& group, const std::string& count,
                         int first, int last) {
  std::vector<double> values;
  for (const json& row : group.rows) {
    double sum = 0;
    for (int i = first; i <= last; ++i) {
      sum += row.at(count).at(static_cast<size_t>(i)).get<double>();
    }
    values.push_back(sum);
  }
  MeanAndSd summary;
  const double n = static_cast<double>(values.size());
  for (const double value : values) summary.mean += value / n;
  for (const double value : values) {
    summary.sd += (value - summary.mean) * (value - summary.mean);
  }
  summary.sd = n > 1 ? std::sqrt(summary.sd / (n - 1)) : 0;
  return summary;
}

RowShape RexdRowShape(int num_episodes) {
  using enum RowShape::Kind;
  const RowShape numbers =
      RowShape::ListOf(kWhole, static_cast<size_t>(num_episodes));
  const RowShape probability = RowShape::ListOf(kNumber, 2);
  return RowShape::Counts({"states", "valid"})
      .With({{"actions", numbers},
             {"demonstrations", numbers},
             {"explorations", numbers},
             {"reached", numbers},
             {"fatal_rules", numbers},
             {"shown_falls", numbers},
             {"probabilities", RowShape::MapOf(probability)}});
}

std::string RexdText(const RexdGroup& group, int num_episodes, double floor) {
  std::string text;
  for (int last = 0; last <= num_episodes; ++last) {
    const bool is_total = last == num_episodes;
    const int first = is_total ? 0 : last;
    const int end = is_total ? last - 1 : last;
    text += fmt::format("  episode {:>3}:",
                        is_total ? "all" : std::to_string(last + 1));
    for (const char* count : kCounts) {
      const MeanAndSd s = SummariseCount(group, count, first, end);
      text += fmt::format("  {} {:.1f} (sd {:.1f})", count, s.mean, s.sd);
    }
    const int number = end - first + 1;
    text += fmt::format(
        "  goal reached {:.1f} %  (at least {:.1f} actions)\n",
        100 * SummariseCount(group, "reached", first, end).mean / number,
        floor * number / group.success);
  }
  if (num_episodes > 2) {
    text += fmt::format(
        "  first two episodes: actions {:.1f}, demonstrations {:.1f}\n",
        SummariseCount(group, "actions", 0, 1).mean,
        SummariseCount(group, "demonstrations", 0, 1).mean);
  }
  return text + FrozenText(group) + RatesText(group) + DeadEndsText(group);
}

std::string RexdCsv(const std::vector<RexdGroup>& groups, int num_episodes) {
  std::string csv = "success,episode";
  for (const char* count : kCounts) csv += fmt::format(",{0},{0}_sd", count);
  csv += ",goal_reached\n";
  for (const RexdGroup& group : groups) {
    for (int i = 0; i < num_episodes; ++i) {
      csv += fmt::format("{},{}", group.success, i + 1);
      for (const char* count : kCounts) {
        const MeanAndSd s = SummariseCount(group, count, i, i);
        csv += fmt::format(",{},{}", s.mean, s.sd);
      }
      csv += fmt::format(",{}\n", SummariseCount(group, "reached", i, i).mean);
    }
  }
  return csv;
}

std::string RexdPlot(const std::vector<RexdGroup>& groups, int num_episodes,
                     const std::string& csv, const std::string& png) {
  std::string text = fmt::format(
      "set terminal pngcairo size 900,1100\nset output '{}'\n"
      "set datafile sep ','\nset multiplot layout 3,1\n"
      "set xrange [0.5:{}.5]\nset yrange [0:]\nset xtics 1\nset grid\n"
      "set key outside\nset xlabel 'episode'\n",
      png, num_episodes);
  int column = 3;
  for (const char* count : kCounts) {
    text += fmt::format("set ylabel '{}'\nplot ", count);
    for (size_t i = 0; i < groups.size(); ++i) {
      const size_t first = 1 + i * static_cast<size_t>(num_episodes);
      text += fmt::format(
          "{}'{}' every ::{}::{} using ($2+{:.2f}):{}:{} with yerrorlines "
          "title 'success {}'",
          i > 0 ? ", " : "", csv, first,
          first + static_cast<size_t>(num_episodes) - 1,
          0.06 * static_cast<double>(i), column, column + 1, groups[i].success);
    }
    text += "\n";
    column += 2;
  }
  return text + "unset multiplot\n";
}

}  // namespace cell::cli
