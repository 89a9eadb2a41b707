#include "services/planner/execution/clean_up.h"

#include "services/planner/execution/done.h"

namespace cell::planner {

NextState CleanUp::Step(ExecutionContext& context, Instant now,
                        Decisions& out) {
  if (!context.MayBegin(now, out)) return nullptr;
  SkillDispatch& dispatch = context.dispatch;
  bool is_finished = true;
  for (const int arm : dispatch.arms().arms()) {
    if (finished_.contains(arm)) continue;
    is_finished = false;
    if (!dispatch.IsFree(arm)) continue;
    dispatch.Start(RequestToCleanUp(arm, dispatch.arms().Of(arm)->held),
                   std::nullopt, State(0), now, out);
  }
  if (!is_finished) return nullptr;
  return std::make_unique<Done>(left_over_);
}

void CleanUp::OnSkillEnd(const EndedSkill& ended) {
  const SkillRequest& request = ended.skill.request;
  if (request.purpose != SkillRequest::Purpose::kCleanUp) return;
  // What it has put down leaves it to go home yet.
  if (ended.has_succeeded) {
    if (request.arguments.empty()) finished_.insert(request.arm);
    return;
  }
  if (!ended.counts || ++num_failed_[request.arm] < max_attempts_) return;
  finished_.insert(request.arm);
  left_over_ = ended.reason;
}

}  // namespace cell::planner
