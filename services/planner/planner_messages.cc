#include "services/planner/planner_messages.h"

#include <set>

#include "common/relational/ground_action.h"

namespace cell::planner {
namespace {

std::optional<Truth> ToTruth(int8_t code) {
  switch (code) {
    case literal_t::FALSE_:
      return Truth::kFalse;
    case literal_t::TRUE_:
      return Truth::kTrue;
    case literal_t::UNKNOWN:
      return Truth::kUnknown;
    default:
      return std::nullopt;
  }
}

std::optional<int> AtomOf(const literal_t& literal, const Vocabulary& v) {
  const std::optional<int> predicate = v.FindPredicate(literal.predicate);
  if (!predicate) return std::nullopt;
  const auto& types = v.predicates()[*predicate].argument_types;
  if (literal.arguments.size() != types.size()) return std::nullopt;
  std::vector<int> objects;
  for (const std::string& name : literal.arguments) {
    const std::optional<int> object = v.FindObject(name);
    if (!object) return std::nullopt;
    objects.push_back(*object);
  }
  return v.AtomIndex(*predicate, objects);
}

int8_t CodeOf(Plan::Result result) {
  switch (result) {
    case Plan::Result::kFound:
      return plan_t::FOUND;
    case Plan::Result::kGoalReached:
      return plan_t::GOAL_REACHED;
    case Plan::Result::kNoPlan:
      return plan_t::NO_PLAN;
    case Plan::Result::kNotLearned:
      return plan_t::NOT_LEARNED;
    case Plan::Result::kUndecided:
      return plan_t::UNDECIDED;
  }
  return plan_t::UNDECIDED;
}

int8_t CodeOf(Alert::Cause cause) {
  switch (cause) {
    case Alert::Cause::kLongerPlan:
      return alert_t::LONGER_PLAN;
    case Alert::Cause::kNoPlan:
      return alert_t::NO_PLAN;
    case Alert::Cause::kUnexplained:
      return alert_t::UNSEEN;
    case Alert::Cause::kStuck:
      return alert_t::STUCK;
    case Alert::Cause::kBadInput:
      return alert_t::BAD_INPUT;
  }
  return alert_t::BAD_INPUT;
}

std::vector<plan_step_t> ToMessages(const std::vector<PlanStep>& steps,
                                    const RuleSet& rules) {
  std::vector<plan_step_t> messages;
  for (const PlanStep& step : steps) {
    plan_step_t& message = messages.emplace_back();
    message.action = rules.ActionOf(step.action).name;
    for (const int object : step.action.arguments) {
      message.arguments.push_back(rules.vocabulary().objects()[object].name);
    }
    message.num_arguments = static_cast<int32_t>(message.arguments.size());
    message.probability = step.probability;
    message.expected_actions = step.expected_actions;
  }
  return messages;
}

}  // namespace

std::optional<SensedState> FromMessage(const predicates_t& message,
                                       const Vocabulary& vocabulary) {
  SensedState sensed{message.key_frame, message.header.utime,
                     State(vocabulary.num_atoms())};
  if (message.key_frame < 0) return std::nullopt;
  for (int atom = 0; atom < vocabulary.num_atoms(); ++atom) {
    sensed.state.Set(atom, Truth::kUnknown);
  }
  std::set<int> seen;
  for (const literal_t& literal : message.literals) {
    const std::optional<int> atom = AtomOf(literal, vocabulary);
    const std::optional<Truth> truth = ToTruth(literal.value);
    if (!atom || !truth || !seen.insert(*atom).second) return std::nullopt;
    sensed.state.Set(*atom, *truth);
  }
  return sensed;
}

namespace {

/// The action with the objects it was seen with; the part that was moved may
/// stand in for what the rules take.
std::optional<GroundAction> ObservedAction(const recognised_action_t& message,
                                           int part, const RuleSet& rules) {
  const Vocabulary& vocabulary = rules.vocabulary();
  const auto index = FindAction(rules.actions(), message.name);
  if (!index) return std::nullopt;
  const auto& arguments =
      rules.actions()[static_cast<size_t>(*index)].arguments;
  if (message.arguments.size() != arguments.size()) return std::nullopt;
  GroundAction ground{*index, {}};
  for (size_t i = 0; i < arguments.size(); ++i) {
    const auto object = vocabulary.FindObject(message.arguments[i]);
    if (!object ||
        (object != part && !vocabulary.IsOf(*object, arguments[i].type))) {
      return std::nullopt;
    }
    ground.arguments.push_back(*object);
  }
  return ground;
}

}  // namespace

std::optional<DoneAction> FromMessage(const recognised_action_t& message,
                                      const RuleSet& rules) {
  const std::optional<int> part = rules.vocabulary().FindObject(message.part);
  constexpr int64_t kMaxUtime = int64_t{1} << 60;  // sums stay in range
  if (!part || message.index < 0 || message.header.utime < 0 ||
      message.header.utime > kMaxUtime || message.pick_key_frame < 0 ||
      message.place_key_frame < message.pick_key_frame) {
    return std::nullopt;
  }
  // Unlike the index, the message's identity outlives the recognizer.
  const int64_t identity =
      (int64_t{message.header.sender} << 32) | message.header.seq;
  DoneAction action{identity,
                    message.header.utime,
                    message.pick_key_frame,
                    message.place_key_frame,
                    {*part},
                    "moving " + message.part,
                    message.pick_utime};
  if (message.kind == recognised_action_t::UNKNOWN) return action;
  const auto ground = ObservedAction(message, *part, rules);
  if (!ground) return std::nullopt;
  action.objects.insert(action.objects.end(), ground->arguments.begin(),
                        ground->arguments.end());
  action.text = rules.Show(*ground);
  if (message.kind == recognised_action_t::FORWARD) return action;
  if (message.kind != recognised_action_t::REVERSED) return std::nullopt;
  action.text = "taking back " + action.text;
  return action;
}

namespace {

/// The action that the named one reverses is done by this one; nullopt if there
/// is none.
std::optional<std::string> NameOfReverse(const std::string& name,
                                         const RuleSet& rules) {
  const auto undone = FindAction(rules.actions(), name);
  for (const Action& action : rules.actions()) {
    if (undone && action.undoes == undone) return action.name;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ShownAction> ShownActionFrom(
    const recognised_action_t& message,
    const std::set<std::string>& hands_of_people, const RuleSet& rules) {
  const Vocabulary& vocabulary = rules.vocabulary();
  const bool is_by_person = std::ranges::any_of(
      message.hands,
      [&](const std::string& hand) { return hands_of_people.contains(hand); });
  if (message.name.empty() || !is_by_person || message.pick_key_frame < 0 ||
      message.place_key_frame < message.pick_key_frame) {
    return std::nullopt;
  }
  ShownAction shown{
      message.name, {}, false, message.pick_key_frame, message.place_key_frame};
  for (const std::string& name : message.arguments) {
    const auto object = vocabulary.FindObject(name);
    if (!object) return std::nullopt;
    shown.objects.push_back(*object);
  }
  if (message.kind != recognised_action_t::REVERSED) return shown;
  const auto reverse = NameOfReverse(message.name, rules);
  shown.is_reversed = !reverse;
  if (reverse) shown.action = *reverse;
  return shown;
}

plan_t ToMessage(const PlanOfState& of_state, const RuleSet& rules) {
  const Plan& plan = of_state.plan;
  plan_t message{};
  message.header.utime = of_state.utime;
  message.key_frame = of_state.key_frame;
  message.result = CodeOf(plan.result);
  message.reason = plan.reason;
  message.probability = plan.probability;
  message.expected_actions = plan.expected_actions;
  message.steps = ToMessages(plan.steps, rules);
  message.num_steps = static_cast<int32_t>(message.steps.size());
  message.next = ToMessages(plan.next, rules);
  message.num_next = static_cast<int32_t>(message.next.size());
  return message;
}

alert_t ToMessage(const Alert& alert) {
  alert_t message{};
  message.header.utime = alert.utime;
  message.cause = CodeOf(alert.cause);
  const bool is_error = alert.cause == Alert::Cause::kNoPlan ||
                        alert.cause == Alert::Cause::kBadInput;
  message.level = is_error ? alert_t::ERROR : alert_t::WARNING;
  message.text = alert.text;
  return message;
}

}  // namespace cell::planner
