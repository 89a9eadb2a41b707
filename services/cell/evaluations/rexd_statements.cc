#include "services/cell/evaluations/rexd_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cell::cli {
namespace {

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

std::vector<RexdStatement> CheckRexdStatements(
    const std::vector<RexdGroup>& groups, int num_episodes, double floor) {
  return Statements(groups, num_episodes, floor).Check();
}

std::string ToText(const std::vector<RexdStatement>& statements) {
  std::string text;
  for (const RexdStatement& statement : statements) {
    text += fmt::format("{:5} {}: {}\n", statement.is_true ? "true" : "false",
                        statement.text, statement.found);
  }
  return text;
}

}  // namespace cell::cli
