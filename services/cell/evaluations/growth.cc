#include "services/cell/evaluations/growth.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "common/planning/planner.h"
#include "common/rexd/rule_model.h"
#include "common/rules/learning/learner.h"
#include "common/rules/simulation.h"

namespace cell::cli {
namespace {

constexpr char kTreeRules[] = R"(
rests 2 primitive
placed 1 primitive
place 2 action <-- rests(X Y)

Action: place(X, Y)
Preconditions: placed(Y), not placed(X)
Effects:
  0.9: placed(X)
  0.1: nothing
  0: noise
)";

/// Experiences between two starts.
constexpr int kEpisodeFactor = 2;

std::string TreePart(int i) {
  return fmt::format("part_{}", i);
}

}  // namespace

rexd::RexdTask TreeTask(int num_objects) {
  std::string objects = "objects:", start = "start: placed(part_0)",
              goal = "goal:";
  for (int i = 0; i < num_objects; ++i) {
    objects += " " + TreePart(i);
    goal += fmt::format(" placed({})", TreePart(i));
    if (i == 0) continue;
    start += fmt::format(" rests({} {})", TreePart(i), TreePart((i - 1) / 2));
  }
  return rexd::ParseRexdTask(
      objects + "\n" + start + "\n" + goal + "\n" + kTreeRules, "tree");
}

GrowthSeries MeasureGrowth(GrowthSeries series, const std::vector<int>& sizes,
                           double most_seconds, const Stopwatch& now,
                           const std::function<double(int)>& measure) {
  for (const int size : sizes) {
    const double begin = now();
    const double result = measure(size);
    series.points.push_back({size, now() - begin, result});
    if (series.points.back().seconds > most_seconds) break;
  }
  return series;
}

double PlanTree(int num_objects, int64_t max_expansions) {
  const rexd::RexdTask task = TreeTask(num_objects);
  const auto model = std::make_shared<rexd::RuleModel>(
      task.truth, task, rules::GroundActs(*task.world, task.initial));
  planning::Planner::Params params;
  params.max_expansions = max_expansions;
  planning::Planner planner(model, params);
  return static_cast<double>(
      planner.Find(model->Pack(task.initial)).num_expansions);
}

double LearnTree(int num_objects, int num_experiences, uint64_t seed) {
  const rexd::RexdTask task = TreeTask(num_objects);
  const rules::ExperienceSet set = rules::DrawExperiences(
      task.truth, task.world, task.initial, num_experiences,
      kEpisodeFactor * num_objects, seed);
  rules::Learner learner(set.world, {});
  for (const rules::Experience& experience : set.experiences) {
    learner.Add(experience);
  }
  learner.Learn();
  return learner.Score();
}

std::string GrowthText(const std::vector<GrowthSeries>& all) {
  std::string text;
  for (const GrowthSeries& series : all) {
    text += fmt::format("{}\n{:>12} {:>10} {:>14}\n", series.name, series.size,
                        "seconds", series.found);
    for (const auto& point : series.points) {
      text += fmt::format("{:>12} {:>10.4f} {:>14.1f}\n", point.size,
                          point.seconds, point.result);
    }
  }
  return text;
}

std::string GrowthCsv(const std::vector<GrowthSeries>& all) {
  std::string csv = "series,grows,size,seconds,found,result\n";
  for (const GrowthSeries& series : all) {
    for (const auto& point : series.points) {
      csv += fmt::format("{},{},{},{},{},{}\n", series.name, series.size,
                         point.size, point.seconds, series.found, point.result);
    }
  }
  return csv;
}

std::string GrowthPlot(const std::vector<GrowthSeries>& all,
                       const std::string& csv, const std::string& png) {
  std::string text = fmt::format(
      "set terminal pngcairo size {},500\nset output '{}'\n"
      "set datafile sep ','\nset multiplot layout 1,{}\nset logscale xy\n"
      "set grid\nset ylabel 'seconds'\nunset key\n",
      450 * all.size(), png, all.size());
  size_t first = 1;
  for (const GrowthSeries& series : all) {
    text += fmt::format(
        "set title '{}'\nset xlabel '{}'\n"
        "plot '{}' every ::{}::{} using 3:4 with linespoints\n",
        series.name, series.size, csv, first, first + series.points.size() - 1);
    first += series.points.size();
  }
  return text + "unset multiplot\n";
}

}  // namespace cell::cli
