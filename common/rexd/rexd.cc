#include "common/rexd/rexd.h"

#include <algorithm>
#include <cmath>

#include "common/planning/planner.h"

namespace cell::rexd {

using namespace rules;

RexD::RexD(const RexdTask& task, const Params& params)
    : task_(task),
      params_(params),
      learner_(task.world, params.learner),
      rules_{task.world->shared_symbols(), {}},
      random_(params.seed) {}

std::vector<GroundAct> RexD::KnownActs() const {
  std::vector<GroundAct> acts;
  for (GroundAct& act : GroundActs(*task_.world, task_.initial)) {
    if (actions_.contains(act.action)) acts.push_back(std::move(act));
  }
  return acts;
}

double RexD::ChangeProbability(const GroundAct& act,
                               const WorldState& state) const {
  const auto coverage = FindCoverage(rules_, act, state, *task_.world);
  if (!coverage) return 0;
  double p = coverage->rule->noise;
  for (const Outcome& outcome : coverage->rule->outcomes) {
    if (Apply(outcome, coverage->binding, state, *task_.world) != state) {
      p += outcome.probability;
    }
  }
  const double count =
      counts_[static_cast<size_t>(coverage->rule - rules_.rules.data())];
  return (count * p + 1) / (count + 2);
}

bool RexD::IsNoOp(const GroundAct& act, const WorldState& state) const {
  const auto coverage = FindCoverage(rules_, act, state, *task_.world);
  if (!coverage || coverage->rule->noise > 0) return false;
  return std::ranges::all_of(
      coverage->rule->outcomes, [&](const Outcome& outcome) {
        return Apply(outcome, coverage->binding, state, *task_.world) == state;
      });
}

std::optional<GroundAct> RexD::LeastTried(const WorldState& state) {
  std::vector<GroundAct> least;
  int least_count = params_.known_count;
  for (const GroundAct& act : KnownActs()) {
    const auto coverage = FindCoverage(rules_, act, state, *task_.world);
    if (!coverage || IsDangerous(act, state)) continue;
    const int count =
        counts_[static_cast<size_t>(coverage->rule - rules_.rules.data())];
    if (count > least_count || count >= params_.known_count) continue;
    if (!params_.explores_no_ops && IsNoOp(act, state)) continue;
    if (count < least_count) least.clear();
    least_count = count;
    least.push_back(act);
  }
  if (least.empty()) return std::nullopt;
  return least[static_cast<size_t>(
      random_.Below(static_cast<int>(least.size())))];
}

std::optional<GroundAct> RexD::Plan(const WorldState& state) {
  std::vector<GroundAct> acts = KnownActs();
  std::erase_if(acts,
                [&](const GroundAct& act) { return IsDangerous(act, state); });
  const auto model =
      std::make_shared<RuleModel>(rules_, task_, std::move(acts));
  planning::Planner::Params params;
  params.max_expansions = params_.max_expansions;
  params.precision = 1e-3;
  planning::Planner planner(model, params);
  const planning::Plan plan = planner.Find(model->Pack(state));
  if (plan.status != planning::Plan::Status::kFound || plan.course.empty()) {
    return std::nullopt;
  }
  return model->acts()[static_cast<size_t>(plan.course[0].action)];
}

bool RexD::HasFailedTooOften(const GroundAct& act,
                             const WorldState& state) const {
  return last_ && last_->act == act && last_->after == state &&
         num_failures_ > 0 &&
         std::pow(1 - p_at_first_, num_failures_) <
             params_.least_failure_probability;
}

Decision RexD::Decide(const WorldState& state) {
  if (shown_in_vain_ && last_ && last_->after == state &&
      num_repetitions_ < params_.max_repetitions) {
    ++num_repetitions_;
    return {Decision::Kind::kExplore, *shown_in_vain_};
  }
  if (const auto act = LeastTried(state)) {
    return {Decision::Kind::kExplore, *act};
  }
  const auto act = Plan(state);
  if (!act || HasFailedTooOften(*act, state)) return {};
  return {Decision::Kind::kExploit, *act};
}

void RexD::Observe(const Experience& experience, bool is_demonstrated) {
  if (is_demonstrated) {
    num_repetitions_ = 0;
    shown_in_vain_ = experience.act;
  }
  if (experience.before != experience.after) shown_in_vain_.reset();
  const bool is_repeated = last_ && num_failures_ > 0 &&
                           last_->act == experience.act &&
                           last_->before == experience.before;
  if (!is_repeated) {
    num_failures_ = 0;
    p_at_first_ = ChangeProbability(experience.act, experience.before);
  }
  if (experience.before == experience.after) ++num_failures_;
  if (last_) harmless_.merge(EffectsOf(*last_));
  last_ = experience;
  actions_.insert(experience.act.action);
  learner_.Add(experience);
  learner_.Learn();
  rules_ = learner_.Rules();
  counts_ = learner_.RuleCounts();
}

std::set<RexD::Effect> RexD::EffectsOf(const Experience& experience) const {
  std::set<Effect> effects;
  const World& world = *task_.world;
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (world.symbols()[symbol].kind != Symbol::Kind::kPrimitive ||
        world.symbols()[symbol].is_integer) {
      continue;
    }
    for (int i = 0; i < world.num_places(symbol); ++i) {
      const int place = world.first(symbol) + i;
      const bool after = World::Get(experience.after, place);
      if (after != World::Get(experience.before, place)) {
        effects.emplace(symbol, after);
      }
    }
  }
  return effects;
}

void RexD::RememberDeadEnd() {
  if (!last_) return;
  for (const Effect& effect : EffectsOf(*last_)) {
    if (!harmless_.contains(effect)) dangers_.insert(effect);
  }
  last_.reset();
}

bool RexD::IsDangerous(const GroundAct& act, const WorldState& state) const {
  if (dangers_.empty()) return false;
  const auto coverage = FindCoverage(rules_, act, state, *task_.world);
  if (!coverage) return false;
  return std::ranges::any_of(
      coverage->rule->outcomes, [&](const Outcome& outcome) {
        return outcome.probability > 0 &&
               std::ranges::any_of(outcome.changes, [&](const Literal& l) {
                 return dangers_.contains(
                     {l.symbol, l.comparison == Comparison::kTrue});
               });
      });
}

}  // namespace cell::rexd
