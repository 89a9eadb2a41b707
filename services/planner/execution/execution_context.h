#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/relational/request_words.h"
#include "services/planner/current_plan.h"
#include "services/planner/dialogue.h"
#include "services/planner/exploration.h"
#include "services/planner/sensing.h"
#include "services/planner/skill_dispatch.h"
#include "services/planner/stand_in_offer.h"

namespace cell::planner {

struct ExecutionParams {
  SkillDispatch::Params dispatch = {};
  /// [us] after the end of a skill until relations and poses show it.
  int64_t settle_us = 500'000;
  int64_t sense_period_us = 200'000;    ///< until the estimator is asked again
  int64_t watch_period_us = 1'000'000;  ///< the same while a person is asked
  int64_t patience_us = 5'000'000;      ///< with what cannot be decided
  bool parallel = true;  ///< hand a part over while another is inserted
  /// Steps that are left to a person: the cell asks for them.
  std::set<GroundAction> help_steps = {};
  RequestWords requests = {};  ///< how the person is asked
  /// If the cell learns: how it explores.
  std::optional<Exploration> exploration = {};
  /// By which parts are known that can stand in for others; nullptr: none is.
  std::shared_ptr<const SecModels> sec_models = {};
  /// [us] for an experience to become a rule, before anything else is done.
  int64_t lesson_us = 400'000;
};

/// What the states of an execution work with.
struct ExecutionContext {
  ExecutionParams params;
  CurrentPlan plan;
  SkillDispatch dispatch;
  Sensing sensing;
  Dialogue dialogue;
  bool may_act = false;  ///< the cell's mode lets arms begin something
  /// Trials whose result has not been sensed yet.
  std::vector<TaskExperience> trials = {};
  /// Arms have gone home since their last action, for a person who is asked.
  bool have_arms_left_room = false;
  /// [us] Until then the last experience may still become a rule.
  int64_t lesson_utime = 0;

  /// Actions that the robot is not to begin now.
  std::set<GroundAction> NotToBegin() const {
    std::set<GroundAction> blocked = dispatch.failures().Blocked();
    blocked.insert(params.help_steps.begin(), params.help_steps.end());
    return blocked;
  }
  /// True if arms may begin something. First it asks arms with an interrupted
  /// skill to go free.
  bool MayBegin(Instant now, Decisions& out) {
    if (!may_act || !dispatch.HaveArmsReported()) return false;
    if (sensing.IsDue(now)) dispatch.StartGoingFree(now, out);
    return !dispatch.HasArmToFree();
  }

  /// Nullopt if the action is left to the person.
  std::optional<SkillRequest> RequestToArm(const GroundAction& action) const {
    if (params.help_steps.contains(action)) return std::nullopt;
    return RequestFor(action, plan.rules());
  }

  /// True of an action that was learned and that no arm has done yet.
  bool IsNew(const GroundAction& action) const {
    const Action& lifted = plan.rules().ActionOf(action);
    return params.exploration &&
           !params.exploration->shipped.contains(lifted.name) &&
           IsNewToArms(lifted, *params.exploration->experiences);
  }
  /// True of one that an operator has to let arms do.
  bool AwaitsConfirmation(const GroundAction& action) const {
    return IsNew(action) && params.exploration->needs_confirmation &&
           !params.exploration->confirmed.contains(
               plan.rules().ActionOf(action).name);
  }
  /// Asks the arm, which must be free.
  void Start(SkillRequest request, const GroundAction& action,
             const State& state, Instant now, Decisions& out) {
    request.is_careful = IsNew(action);
    have_arms_left_room = false;
    dispatch.Start(std::move(request), action, state, now, out);
  }

  /// Arms with empty hands go home, once. False if there are none.
  bool LeaveRoom(Instant now, Decisions& out) {
    if (!params.exploration || std::exchange(have_arms_left_room, true)) {
      return false;
    }
    for (const int arm : dispatch.arms().arms()) {
      if (!dispatch.IsFree(arm) || dispatch.arms().Of(arm)->held) continue;
      dispatch.Start(RequestToCleanUp(arm, std::nullopt), std::nullopt,
                     State(0), now, out);
    }
    return !dispatch.running().empty();
  }

  /// What was sensed and what arms report. @pre the sensed state is fresh.
  State StateNow() const {
    return dispatch.arms().WithReports(sensing.Fresh()->state);
  }
};

}  // namespace cell::planner
