#include "common/rexd/rexd.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/rexd/rule_alternatives.h"

namespace cell::rexd {

using namespace rules;
namespace {

/// A predicate that becomes true or false, of whatever objects.
using Effect = std::pair<int, bool>;

/// Calls visit(symbol, place, truth afterwards) for each atom that changed.
template <class Visit>
void ForEachChange(const Experience& experience, const World& world,
                   Visit visit) {
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
        visit(symbol, place, after);
      }
    }
  }
}

std::set<Effect> EffectsOf(const Experience& experience, const World& world) {
  std::set<Effect> effects;
  ForEachChange(experience, world, [&](int symbol, int /*place*/, bool after) {
    effects.insert({symbol, after});
  });
  return effects;
}

}  // namespace

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

planning::Planner::Params RexD::PlannerParams() const {
  planning::Planner::Params params;
  params.max_expansions = params_.max_expansions;
  params.precision = 1e-3;
  return params;
}

std::optional<GroundAct> RexD::PlanBy(const NdrRules& rules,
                                      const RexdTask& task,
                                      const WorldState& state) const {
  std::vector<GroundAct> acts = KnownActs();
  while (true) {
    const auto model = std::make_shared<RuleModel>(rules, task, acts);
    planning::Planner planner(model, PlannerParams());
    const planning::Plan plan = planner.Find(model->Pack(state));
    if (plan.status != planning::Plan::Status::kFound || plan.course.empty()) {
      return std::nullopt;
    }
    const GroundAct first =
        model->acts()[static_cast<size_t>(plan.course[0].action)];
    if (!IsDangerous(first, state)) return first;
    std::erase(acts, first);
  }
}

std::optional<GroundAct> RexD::Plan(const WorldState& state) {
  return PlanBy(rules_, task_, state);
}

std::shared_ptr<RuleModel> RexD::Model() const {
  return std::make_shared<RuleModel>(rules_, task_, KnownActs());
}

std::optional<GroundAct> RexD::DoWithoutPlan(const WorldState& state,
                                             const Guidance& guidance) {
  constexpr size_t kMaxPlans = 30;
  if (num_alternatives_ < params_.max_alternatives) {
    const auto alternatives =
        RuleAlternatives(rules_, *task_.world, state, guidance, experiences_);
    for (size_t i = 0; i < std::min(alternatives.size(), kMaxPlans); ++i) {
      const auto act = PlanBy(alternatives[i], task_, state);
      if (!act) continue;
      ++num_alternatives_;
      return act;
    }
  }
  if (!params_.uses_subgoals || guidance.subgoals.empty()) return std::nullopt;
  RexdTask meanwhile = task_;
  meanwhile.goal = guidance.subgoals;
  const auto act = PlanBy(rules_, meanwhile, state);
  if (act && HasFailedTooOften(*act, state)) return std::nullopt;
  return act;
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
      num_repetitions_ < params_.max_repetitions &&
      !IsDangerous(*shown_in_vain_, state)) {
    ++num_repetitions_;
    return {Decision::Kind::kExplore, *shown_in_vain_, {}};
  }
  if (const auto act = LeastTried(state)) {
    return {Decision::Kind::kExplore, *act, {}};
  }
  const auto act = Plan(state);
  const bool is_stuck = act && HasFailedTooOften(*act, state);
  if (act && !is_stuck) return {Decision::Kind::kExploit, *act, {}};
  if (is_stuck) return {Decision::Kind::kAsk, {}, {}};
  const Guidance guidance = FindGuidance(rules_, task_, state, KnownActs());
  if (const auto other = DoWithoutPlan(state, guidance)) {
    return {Decision::Kind::kExploit, *other, {}};
  }
  return {Decision::Kind::kAsk, {}, guidance};
}

void RexD::Observe(const Experience& experience, bool is_demonstrated) {
  if (is_demonstrated) {
    num_repetitions_ = 0;
    num_alternatives_ = 0;
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
  last_ = experience;
  actions_.insert(experience.act.action);
  experiences_.push_back(experience);
  learner_.Add(experience);
  learner_.Learn();
  rules_ = learner_.Rules();
  counts_ = learner_.RuleCounts();
}

WorldState RexD::Transfer(const Experience& experience, const GroundAct& act,
                          WorldState state) const {
  const World& world = *task_.world;
  ForEachChange(experience, world, [&](int symbol, int place, bool after) {
    std::vector<int> objects = world.ObjectsAt(symbol, place);
    for (int& object : objects) {
      const auto it = std::ranges::find(experience.act.arguments, object);
      if (it == experience.act.arguments.end()) continue;
      object = act.arguments[static_cast<size_t>(
          it - experience.act.arguments.begin())];
    }
    World::Set(&state, world.PlaceOf(symbol, objects), after);
  });
  world.Derive(&state);
  return state;
}

const Experience& RexD::CauseOfDeadEnd() const {
  const Guidance guidance =
      FindGuidance(rules_, task_, experiences_.back().after, KnownActs());
  std::vector<Literal> needed = guidance.missing_effects;
  for (const auto& blocked : guidance.blocked_acts) {
    needed.push_back(blocked.needs);
  }
  for (size_t i = experiences_.size(); i-- > 0;) {
    const Experience& e = experiences_[i];
    const bool has_undone =
        std::ranges::any_of(needed, [&](const Literal& literal) {
          return Holds(literal, {}, e.before, *task_.world) &&
                 !Holds(literal, {}, e.after, *task_.world);
        });
    if (has_undone) return e;
  }
  return experiences_.back();
}

void RexD::RememberDeadEnd() {
  if (!last_) return;
  const Experience& cause = CauseOfDeadEnd();
  dead_ends_.push_back({cause, IsUnheardOf(cause)});
  last_.reset();
}

bool RexD::HasWayOn(const WorldState& state) const {
  const auto model = Model();
  planning::Planner::Params params = PlannerParams();
  params.minimize_actions = false;
  planning::Planner planner(model, params);
  const auto status = planner.Find(model->Pack(state)).status;
  return status == planning::Plan::Status::kFound ||
         status == planning::Plan::Status::kGoalReached;
}

bool RexD::IsUnheardOf(const Experience& experience) const {
  std::map<Effect, int> num_experiences;
  for (const Experience& e : experiences_) {
    for (const Effect& effect : EffectsOf(e, *task_.world)) {
      ++num_experiences[effect];
    }
  }
  return std::ranges::any_of(
      EffectsOf(experience, *task_.world),
      [&](const Effect& effect) { return num_experiences[effect] == 1; });
}

bool RexD::IsDangerous(const GroundAct& act, const WorldState& state) const {
  return std::ranges::any_of(dead_ends_, [&](const DeadEnd& dead_end) {
    if (dead_end.cause.act.action != act.action) return false;
    const WorldState after = Transfer(dead_end.cause, act, state);
    return after != state && (dead_end.is_unheard_of || !HasWayOn(after));
  });
}

}  // namespace cell::rexd
