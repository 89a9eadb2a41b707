#include "services/planner/skill_dispatch.h"

#include <algorithm>
#include <utility>

namespace cell::planner {

using Purpose = SkillRequest::Purpose;

SkillDispatch::SkillDispatch(std::shared_ptr<const Vocabulary> vocabulary,
                             const Params& params, int64_t since_utime)
    : params_(params),
      arms_(vocabulary),
      failures_(vocabulary, params.max_attempts),
      since_utime_(since_utime) {}

std::optional<EndedSkill> SkillDispatch::Update(const SkillResult& result) {
  const auto it = running_.find(result.arm);
  if (it == running_.end() || it->second.request.id != result.id) {
    return std::nullopt;
  }
  const bool has_succeeded = result.outcome == SkillResult::Outcome::kSucceeded;
  const bool is_stopped = result.outcome == SkillResult::Outcome::kStopped;
  const bool counts =
      !is_stopped && result.outcome != SkillResult::Outcome::kYielded;
  if (is_stopped) to_free_.try_emplace(result.arm, 0);
  return End(
      result.arm, result.utime, has_succeeded, counts,
      has_succeeded ? "it was reported as done, but is not" : result.reason);
}

std::vector<EndedSkill> SkillDispatch::EndLostRequests() {
  std::vector<std::pair<int, int64_t>> lost;
  for (auto& [arm, skill] : running_) {
    const ArmState* report = arms_.Of(arm);
    if (report == nullptr || report->utime < skill.heard_utime) continue;
    if (report->request == skill.request.id) {
      skill.heard_utime = report->utime;
    } else if (report->utime - skill.heard_utime >= params_.lost_us) {
      lost.emplace_back(arm, report->utime);
    }
  }
  std::vector<EndedSkill> ended;
  for (const auto& [arm, utime] : lost) {
    if (running_.at(arm).request.purpose != Purpose::kGoFree) {
      to_free_.try_emplace(arm, 0);
    }
    ended.push_back(
        End(arm, utime, false, true, "the arm restarted and lost the request"));
  }
  return ended;
}

EndedSkill SkillDispatch::End(int arm, int64_t utime, bool has_succeeded,
                              bool counts, const std::string& reason) {
  EndedSkill ended{std::move(running_.at(arm)), utime, has_succeeded, counts,
                   reason};
  running_.erase(arm);
  since_utime_ = std::max(since_utime_, utime);
  const RunningSkill& skill = ended.skill;
  // Success shows in the state.
  if (counts && skill.action) {
    failures_.Add(*skill.action, skill.before, reason);
  }
  if (counts && skill.request.purpose == Purpose::kGoFree) {
    OnFreed(arm, has_succeeded);
  }
  return ended;
}

/// An arm that cannot go free is used as it is after some attempts: it refuses
/// what it cannot do.
void SkillDispatch::OnFreed(int arm, bool has_succeeded) {
  const auto it = to_free_.find(arm);
  if (it == to_free_.end()) return;
  if (has_succeeded || ++it->second >= params_.max_attempts) to_free_.erase(it);
}

bool SkillDispatch::IsFree(int arm) const {
  const ArmState* report = arms_.Of(arm);
  return !running_.contains(arm) && report != nullptr &&
         report->request == ArmState::kIdle;
}

bool SkillDispatch::HasFreeArm() const {
  return std::ranges::any_of(arms_.arms(),
                             [this](int arm) { return IsFree(arm); });
}

void SkillDispatch::Start(SkillRequest request,
                          std::optional<GroundAction> action,
                          const State& before, Instant now, Decisions& out) {
  constexpr int64_t kMaxPerTick = 256;
  request.id = int64_t{now.tick} * kMaxPerTick +
               static_cast<int64_t>(out.requests.size());
  request.deadline_utime = now.utime + params_.deadline_us;
  running_.insert_or_assign(
      request.arm, RunningSkill{request, std::move(action), before, now.utime});
  out.requests.push_back(request);
}

void SkillDispatch::StartGoingFree(Instant now, Decisions& out) {
  for (const auto& [arm, num_failed] : to_free_) {
    if (!IsFree(arm)) continue;
    Start(RequestToGoFree(arm), std::nullopt, State(0), now, out);
  }
}

std::string SkillDispatch::ShowRunning(const RuleSet& rules) const {
  std::string text;
  for (const auto& [arm, skill] : running_) {
    if (!text.empty()) text += ", ";
    const bool goes_free = skill.request.purpose == Purpose::kGoFree;
    text += skill.action
                ? rules.Show(*skill.action)
                : rules.vocabulary().objects()[arm].name +
                      (goes_free ? " arm releases its part and draws back"
                                 : " arm goes home");
  }
  return text;
}

}  // namespace cell::planner
