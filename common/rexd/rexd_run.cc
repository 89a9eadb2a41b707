#include "common/rexd/rexd_run.h"

#include <stdexcept>
#include <utility>

namespace cell::rexd {

using namespace rules;
namespace {

/// One run: a learner, its teacher, and the world.
class RexdRun {
 public:
  RexdRun(const RexdTask& task, const RunParams& params)
      : task_(&task),
        params_(params),
        world_rules_(WithSuccess(task.truth, params.success)),
        random_(params.seed),
        teacher_(std::in_place, task, params.success, params.teacher,
                 random_.Next()),
        learner_(task, LearnerParams()) {}

  /// The learner goes on in another task.
  void SetTask(const RexdTask& task) {
    learner_.SetTask(task);
    task_ = &task;
    world_rules_ = WithSuccess(task.truth, params_.success);
    teacher_.emplace(task, params_.success, params_.teacher, random_.Next());
  }

  std::vector<EpisodeCounts> Episodes() {
    std::vector<EpisodeCounts> episodes;
    for (int i = 0; i < params_.num_episodes; ++i) {
      episodes.push_back(Episode());
    }
    return episodes;
  }

  FrozenScore ScoreRules() { return ScoreFrozen(*task_, learner_); }

 private:
  EpisodeCounts Episode() {
    EpisodeCounts counts;
    course_.clear();
    WorldState state = task_->initial;
    while (counts.num_actions < params_.max_actions) {
      if (task_->IsGoal(state)) {
        counts.is_goal_reached = true;
        break;
      }
      if (!Step(&state, &counts)) break;
    }
    counts.is_goal_reached |= task_->IsGoal(state);
    if (!counts.is_goal_reached) FindFall(&counts);
    return counts;
  }

  RexD::Params LearnerParams() {
    RexD::Params params = params_.learner;
    params.seed = random_.Next();
    return params;
  }

  /// False in a dead end.
  bool Step(WorldState* state, EpisodeCounts* counts) {
    const Decision decision = learner_.Decide(*state);
    Experience experience{*state, decision.act, *state};
    if (decision.kind == Decision::Kind::kAsk) {
      const auto act =
          teacher_->Choose(*state, {&learner_.rules(), &decision.guidance});
      if (!act) {
        counts->is_dead_end = true;
        learner_.RememberDeadEnd();
        return false;
      }
      experience.act = *act;
      experience.after = teacher_->Act(*act, *state);
      ++counts->num_demonstrations;
    } else {
      experience.after =
          Simulate(world_rules_, *task_->world, decision.act, *state, &random_);
      counts->num_explorations += decision.kind == Decision::Kind::kExplore;
    }
    ++counts->num_actions;
    course_.emplace_back(experience, decision.kind == Decision::Kind::kAsk);
    learner_.Observe(experience, decision.kind == Decision::Kind::kAsk);
    *state = experience.after;
    return true;
  }

  /// The first action of the episode after which there is no way to the goal.
  void FindFall(EpisodeCounts* counts) {
    for (const auto& [experience, is_demonstrated] : course_) {
      if (teacher_->DistanceFrom(experience.after)) continue;
      const auto coverage = FindCoverage(world_rules_, experience.act,
                                         experience.before, *task_->world);
      if (!coverage) return;
      counts->fatal_rule =
          static_cast<int>(coverage->rule - world_rules_.rules.data());
      counts->is_fall_demonstrated = is_demonstrated;
      return;
    }
  }

  const RexdTask* task_;
  const RunParams& params_;
  NdrRules world_rules_;
  RandomNumbers random_;
  std::optional<PlanningTeacher> teacher_;
  RexD learner_;
  std::vector<std::pair<Experience, bool>> course_;  // is it demonstrated
};

}  // namespace

std::vector<EpisodeCounts> RunRexd(const RexdTask& task,
                                   const RunParams& params,
                                   FrozenScore* frozen) {
  RexdRun run(task, params);
  std::vector<EpisodeCounts> episodes = run.Episodes();
  if (frozen != nullptr) *frozen = run.ScoreRules();
  return episodes;
}

std::vector<std::vector<EpisodeCounts>> RunRexdInTurn(
    const std::vector<RexdTask>& tasks, const RunParams& params) {
  if (tasks.empty()) throw std::invalid_argument("there is no task to learn");
  RexdRun run(tasks.front(), params);
  std::vector<std::vector<EpisodeCounts>> blocks = {run.Episodes()};
  for (size_t i = 1; i < tasks.size(); ++i) {
    run.SetTask(tasks[i]);
    blocks.push_back(run.Episodes());
  }
  return blocks;
}

}  // namespace cell::rexd
