#include "services/planner/execute.h"

#include <algorithm>
#include <utility>

#include "services/planner/execution/await_rest.h"

namespace cell::planner {

Execute::Execute(std::shared_ptr<const RuleSet> rules, const Goal& goal,
                 SolverMaker make_solver, const ExecutionParams& params,
                 bool may_act, Instant now)
    : context_{.params = params,
               .plan = CurrentPlan(rules, goal, std::move(make_solver)),
               .dispatch = SkillDispatch(rules->shared_vocabulary(),
                                         params.dispatch, now.utime),
               .sensing = Sensing(now.utime),
               .dialogue = Dialogue(params.patience_us),
               .may_act = may_act},
      state_(std::make_unique<AwaitRest>()) {}

Decisions Execute::OnSensed(const SensedState& sensed) {
  context_.sensing.Update(sensed);
  Decisions out;
  if (context_.sensing.Fresh() != nullptr) EndTrials(out);
  return out;
}

/// The arms' own skills, which only robots have, are not learned.
void Execute::BeginTrial(const EndedSkill& ended) {
  if (!context_.params.exploration || !ended.counts || !ended.skill.action) {
    return;
  }
  const RuleSet& rules = context_.plan.rules();
  const Action& action = rules.ActionOf(*ended.skill.action);
  if (!action.MayBeDoneBy(Agent::kPerson)) return;
  context_.trials.push_back({action.name, ended.skill.action->arguments,
                             Agent::kRobot, ended.skill.before, State(0)});
}

/// What is sensed now is what came of them.
void Execute::EndTrials(Decisions& out) {
  const Vocabulary& vocabulary = context_.plan.rules().vocabulary();
  for (TaskExperience& trial : context_.trials) {
    trial.before = WithoutArms(trial.before, vocabulary);
    trial.after = WithoutArms(context_.sensing.Fresh()->state, vocabulary);
    context_.lesson_utime =
        context_.sensing.Fresh()->utime + context_.params.lesson_us;
    out.experiences.push_back(std::move(trial));
  }
  context_.trials.clear();
}

Decisions Execute::OnAction(const DoneAction& action) {
  if (!context_.dialogue.OnAction(action)) return {};
  context_.sensing.RequireSince(action.utime + context_.params.settle_us);
  for (const int object : action.objects) {
    context_.dispatch.failures().ForgetAbout(object);
  }
  return {};
}

void Execute::OnArmState(const ArmState& report) {
  context_.dispatch.Update(report);
}

void Execute::OnSkillResult(const SkillResult& result) {
  const auto ended = context_.dispatch.Update(result);
  if (ended) OnSkillEnd(*ended);
}

void Execute::OnSkillEnd(const EndedSkill& ended) {
  context_.sensing.RequireSince(ended.utime + context_.params.settle_us);
  BeginTrial(ended);
  state_->OnSkillEnd(ended);
}

void Execute::SetPermission(bool may_act, Instant now) {
  if (may_act && !context_.may_act) context_.sensing.RequireSince(now.utime);
  context_.may_act = may_act;
}

Decisions Execute::SetRules(std::shared_ptr<const RuleSet> rules) {
  context_.plan.SetRules(std::move(rules));
  context_.lesson_utime = 0;
  return {};
}

void Execute::SetExperiences(
    std::shared_ptr<const std::vector<TaskExperience>> experiences) {
  if (context_.params.exploration) {
    context_.params.exploration->experiences = std::move(experiences);
  }
}

void Execute::Confirm(const std::string& action) {
  if (!context_.params.exploration) return;
  context_.params.exploration->confirmed.insert(action);
  state_ = std::make_unique<AwaitRest>();
}

Decisions Execute::SetGoal(const Goal& goal) {
  context_.plan.SetGoal(goal);
  context_.dispatch.failures().Clear();
  context_.dialogue.OnGoal();
  state_ = std::make_unique<AwaitRest>();
  return {};
}

std::optional<DecisionBasis> Execute::Basis() const {
  const CurrentPlan& plan = context_.plan;
  if (!plan.state()) return std::nullopt;
  DecisionBasis basis{.problem = plan.problem(),
                      .make_solver = plan.make_solver(),
                      .state = *plan.state(),
                      .plan = plan.get(),
                      .failures = context_.dispatch.failures().entries(),
                      .running = context_.dispatch.running(),
                      .exploration = context_.params.exploration,
                      .not_to_begin = context_.NotToBegin()};
  basis.problem.blocked = plan.blocked();
  return basis;
}

Decisions Execute::Decide(Instant now) {
  Decisions out;
  for (const EndedSkill& lost : context_.dispatch.EndLostRequests()) {
    OnSkillEnd(lost);
  }
  while (auto next = state_->Step(context_, now, out)) state_ = std::move(next);
  Dialogue& dialogue = context_.dialogue;
  const bool has_begun_action =
      std::ranges::any_of(out.requests, [](const SkillRequest& request) {
        return request.purpose != SkillRequest::Purpose::kCleanUp;
      });
  if (has_begun_action) dialogue.OnStart();
  if (!dialogue.is_asking()) {
    dialogue.Report(state_->Status(context_), now, out);
  }
  return out;
}

}  // namespace cell::planner
