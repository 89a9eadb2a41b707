#include "services/cell/evaluations/sufficient_evaluation.h"

#include <algorithm>
#include <random>

#include "common/task/shipped_experiences.h"
#include "common/task/task.h"
#include "services/cell/evaluations/row_measures.h"
#include "services/cell/learning/experienced_episodes.h"
#include "services/cell/learning/run_experiences.h"
#include "services/cell/learning/sufficiency.h"

namespace cell::cli {
namespace {

using nlohmann::json;

constexpr size_t kMostEpisodes = 4;

/// Demonstrations in the order in which a cell might see them: some episodes,
/// the last one cut off anywhere.
struct Sequence {
  std::vector<rules::Experience> experiences;
  std::vector<State> starts;  // of the episodes
};

Sequence Draw(std::vector<ExperiencedEpisode> episodes, const RuleWorld& world,
              uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](size_t end) {
    return std::uniform_int_distribution<size_t>(0, end - 1)(random);
  };
  Sequence sequence;
  const size_t number = 1 + below(kMostEpisodes);
  for (size_t i = 0; i < number; ++i) {
    const ExperiencedEpisode& episode = episodes[below(episodes.size())];
    sequence.starts.push_back(
        world.FromWorld(episode.experiences.front().before));
    const size_t size = episode.experiences.size();
    const size_t count = i + 1 < number ? size : 1 + below(size);
    sequence.experiences.insert(
        sequence.experiences.end(), episode.experiences.begin(),
        episode.experiences.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return sequence;
}

class SufficientEvaluation final : public Evaluation {
 public:
  std::string name() const override { return "sufficient"; }
  std::string description() const override {
    return "Say whether demonstrations suffice to reach the goal.";
  }
  int default_runs() const override { return 100; }

  json RunTrial(const Trial& trial, const Deployment& deployment,
                const Roster& /*roster*/) const override {
    const Domain domain = LoadTask(deployment).domain;
    const RuleWorld world = RuleWorldOf(domain);
    const Sequence shown =
        Draw(EpisodesIn(deployment.task_dir / kExperiencesFolder, world), world,
             trial.seed);
    const auto rules = LearnedRuleSet(shown.experiences, domain.goals(), world);
    const Goal& goal = domain.goals().front();
    const Sufficiency judged = JudgeSufficiency(rules, goal, shown.starts);
    const auto truth = RuleSet::FromDomain(domain);
    const bool is_reached =
        std::ranges::all_of(shown.starts, [&](const State& start) {
          return ReachesGoal(rules, goal, *truth, start);
        });
    return {{"experiences", shown.experiences.size()},
            {"episodes", shown.starts.size()},
            {"said", judged.is_sufficient},
            {"reached", is_reached},
            {"uncovered", judged.uncovered.size()}};
  }

  RowShape row_shape() const override {
    using enum RowShape::Kind;
    return RowShape::Record(
        {{"said", kFlag}, {"reached", kFlag}, {"experiences", kWhole}});
  }

  std::vector<Measure> Measures(const std::vector<json>& rows) const override {
    std::vector<json> yes;
    std::vector<json> no;
    for (const json& row : rows) {
      (row.at("said").get<bool>() ? yes : no).push_back(row);
    }
    return {RunsOf(yes, name(), "said to suffice, and the goal is reached",
                   [](const json& row) { return row.at("reached") == true; }),
            RunsOf(no, name(), "said not to suffice, and it is not reached",
                   [](const json& row) { return row.at("reached") == false; })};
  }

  std::vector<Figure> Figures(const std::vector<json>& rows) const override {
    double experiences = 0;
    for (const json& row : rows) {
      experiences += row.at("experiences").get<double>() /
                     static_cast<double>(rows.size());
    }
    return {{"mean number of experiences", experiences, ""}};
  }
};

}  // namespace

std::unique_ptr<Evaluation> MakeSufficientEvaluation() {
  return std::make_unique<SufficientEvaluation>();
}

}  // namespace cell::cli
