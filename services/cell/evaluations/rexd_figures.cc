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

class Statements {
 public:
  Statements(const std::vector<RexdGroup>& groups, int num_episodes,
             double floor)
      : groups_(groups), last_(num_episodes - 1), floor_(floor) {
    std::ranges::sort(groups_, std::ranges::greater(), &RexdGroup::success);
  }

  std::vector<RexdStatement> Check() {
    for (const RexdGroup& group : groups_) {
      if (group.success == 1 && last_ >= 2) CheckDeterministic(group);
      if (group.success == 0.4 && last_ >= 3) CheckNoisiest(group);
    }
    if (groups_.size() > 1) CheckTrends();
    return std::move(statements_);
  }

 private:
  double Mean(const RexdGroup& group, const char* count, int first,
              int last) const {
    return SummariseCount(group, count, first, last).mean;
  }
  void Add(const std::string& text, const std::string& found, bool is_true) {
    statements_.push_back({text, found, is_true});
  }

  void CheckDeterministic(const RexdGroup& group) {
    const double late = Mean(group, "demonstrations", 2, last_);
    Add("success 1: only the initial demonstrations are requested",
        fmt::format("{:.2f} demonstrations after the second episode", late),
        late < 0.5);
    // Of the paper's 37 actions, explorations are at most those that the
    // shortest ways of two episodes leave over.
    const double explorations = Mean(group, "explorations", 0, 1);
    const double most = 37 - 2 * floor_;
    Add("success 1: the number of explorations is low",
        fmt::format("{:.1f} in two episodes; the paper's 37 actions leave "
                    "{:.0f} beside the shortest ways",
                    explorations, most),
        explorations <= most);
    const double two = Mean(group, "actions", 0, 1);
    const double shown = Mean(group, "demonstrations", 0, 1);
    Add("success 1: about 37 actions and 9 demonstrations in two episodes",
        fmt::format("{:.1f} and {:.1f}", two, shown), two <= 37 && shown <= 9);
    const double third = Mean(group, "actions", 2, 2);
    Add("success 1: then the task is completed efficiently",
        fmt::format("{:.1f} actions in the third episode, at least {}", third,
                    floor_),
        third <= 1.1 * floor_);
  }

  void CheckNoisiest(const RexdGroup& group) {
    const double actions = Mean(group, "actions", 0, 3);
    const double shown = Mean(group, "demonstrations", 0, 3);
    Add("success 0.4: about 95 actions and 13 demonstrations in four episodes",
        fmt::format("{:.1f} and {:.1f}", actions, shown),
        actions <= 95 && shown <= 13);
    const double fourth = Mean(group, "actions", 3, 3);
    const double reached = Mean(group, "reached", 3, 3);
    Add("success 0.4: good policies are learned within four episodes",
        fmt::format("{:.1f} actions in the fourth, at least {:.1f}; goal "
                    "reached in {:.1f} %",
                    fourth, floor_ / group.success, 100 * reached),
        fourth <= 1.1 * floor_ / group.success && reached >= 0.99);
  }

  /// True if the mean rises as the success rate falls.
  bool Rises(const char* count, std::string* found) const {
    bool rises = true;
    double before = -1;
    for (const RexdGroup& group : groups_) {
      const double mean = Mean(group, count, 0, last_);
      *found += fmt::format("{}{:.1f}", found->empty() ? "" : ", ", mean);
      rises &= mean > before;
      before = mean;
    }
    return rises;
  }

  void CheckTrends() {
    std::string actions, shown;
    const bool harder = Rises("actions", &actions);
    Add("the complexity rises with the uncertainty", actions + " actions",
        harder);
    const bool more = Rises("demonstrations", &shown);
    Add("as noise increases, extra demonstrations are requested",
        shown + " demonstrations", more);
    double share = 0;
    double late = 0;
    for (const RexdGroup& group : groups_) {
      share = std::max(share, Mean(group, "explorations", 0, last_) /
                                  Mean(group, "actions", 0, last_));
      if (last_ >= 2) {
        late = std::max(late, Mean(group, "explorations", 2, last_));
      }
    }
    Add("explorations stay relatively low even with high noise",
        fmt::format("at most {:.0f} % of the actions", 100 * share),
        share < 0.5);
    Add("unexplored states appear in later episodes, too",
        fmt::format("up to {:.2f} explorations after the second episode", late),
        late > 0);
  }

  std::vector<RexdGroup> groups_;
  int last_;
  double floor_;
  std::vector<RexdStatement> statements_;
};

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

std::vector<RexdStatement> CheckRexdStatements(
    const std::vector<RexdGroup>& groups, int num_episodes, double floor) {
  return Statements(groups, num_episodes, floor).Check();
}

}  // namespace cell::cli
