#include "services/recognizer/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/actions/action_model_writer.h"
#include "common/actions/build_version.h"
#include "common/actions/sec_models.h"
#include "common/sec/chain_similarities.h"

namespace cell::recognizer {
namespace {

/// Noise of the rule of an action that was only observed, never planned.
constexpr double kNoise = 0.05;

std::shared_ptr<const SceneWords> WordsOf(const ActionModels& actions) {
  return std::make_shared<const SceneWords>(
      SceneWords{actions.domain().vocabulary(), actions.parts()});
}

const ActionModel* Find(const ActionModels& actions, const std::string& name) {
  for (const ActionModel& model : actions.models()) {
    if (model.action.name == name) return &model;
  }
  return nullptr;
}

}  // namespace

Learning::Learning(const ActionModels& actions, GenericSkill skill)
    : learner_(WordsOf(actions), MakeChainSimilarity(SecLearner::kMeasure), {}),
      skill_(std::move(skill)) {
  for (const ActionModel& model : actions.models()) {
    if (model.sec) learner_.Know(model.action.name, *model.sec);
  }
}

/// An action without a description in the domain: its effects are those seen,
/// and arms can do it if it ends at a site.
Action Learning::ActionOf(const SecLearner::Action& learned) const {
  const LearnedModel& model = learned.model;
  NdrRule rule;
  rule.agents = {Agent::kPerson};
  rule.context.assign(model.pick.where.begin(), model.pick.where.end());
  Effect effect;
  for (const Literal& literal : ChangedLiterals(model.pick, model.place)) {
    effect.then.push_back(Negated(literal));
  }
  rule.outcomes = {{1 - kNoise, {effect}}};
  rule.noise = kNoise;
  Action action{.name = learned.name,
                .arguments = model.roles,
                .agents = {Agent::kPerson},
                .undoes = {},
                .rules = {rule},
                .skill = skill_.For(model)};
  if (action.skill) action.agents.push_back(Agent::kRobot);
  return action;
}

std::optional<Learning::Shown> Learning::OnManipulation(
    const ObservedManipulation& manipulation, const std::string& source,
    const ActionModels& actions) {
  last_ = learner_.Add(manipulation, source, BuildVersion());
  has_news_ = has_news_ || last_.has_value();
  if (!last_) return std::nullopt;
  if (last_->is_new) ReadAsWhatArmsCanDo();
  return ShownBy(*last_, actions);
}

/// What takes a part out of its seat, and was never seen before, undoes an
/// action that arms can do.
void Learning::ReadAsWhatArmsCanDo() {
  LearnedModel model = learner_.ActionOf(*last_).model;
  if (skill_.For(model)) return;
  std::swap(model.pick, model.place);
  if (skill_.For(model)) learner_.TurnAround(&*last_);
}

/// The roles are those of the group; its record may have another order.
std::optional<Learning::Shown> Learning::ShownBy(
    const SecLearner::Lesson& lesson, const ActionModels& actions) const {
  if (lesson.direction != ActionDirection::kForward ||
      std::ranges::count(lesson.objects, -1) > 0) {
    return std::nullopt;
  }
  const Vocabulary& vocabulary = actions.domain().vocabulary();
  const SecLearner::Action learned = learner_.ActionOf(lesson);
  const ActionModel* known = Find(actions, learned.name);
  const auto order = ArgumentsOf(
      learned.model.roles,
      known != nullptr ? known->action.arguments : learned.model.roles,
      vocabulary.types());
  if (!order) return std::nullopt;
  Shown shown{learned.name, std::vector<std::string>(order->size())};
  for (size_t role = 0; role < order->size(); ++role) {
    const auto object = static_cast<size_t>(lesson.objects[role]);
    shown.arguments[(*order)[role]] = vocabulary.objects()[object].name;
  }
  return shown;
}

Result<std::string> Learning::Name(const std::string& name, bool is_undone,
                                   const ActionModels& actions) {
  if (!last_) {
    return Reason{
        "nothing was shown that changes a predicate or what the moved part "
        "touches"};
  }
  const SecLearner::Action shown = learner_.ActionOf(*last_);
  const ActionModel* known = Find(actions, name);
  const TypeHierarchy& types = actions.domain().vocabulary().types();
  if (known != nullptr) {
    const auto fitting =
        ArgumentsOf(shown.model.roles, known->action.arguments, types);
    if (!fitting) return Reason{name + ": " + fitting.reason()};
  }
  const Result<size_t> group = learner_.Name(*last_, name, is_undone);
  if (!group) return Reason{group.reason()};
  if (known != nullptr) WidenTo(known->action.arguments, *group, types);
  last_ = SecLearner::Lesson{
      *group,
      is_undone ? ActionDirection::kReversed : ActionDirection::kForward,
      false,
      {}};
  if (!shown.is_named) renamed_.insert(shown.name);
  has_news_ = true;
  return fmt::format("what was shown {} {}", is_undone ? "undoes" : "is", name);
}

/// What is recognised as the action from now on is a showing of it, too.
void Learning::WidenTo(const std::vector<Variable>& arguments, size_t group,
                       const TypeHierarchy& types) {
  const LearnedModel model =
      learner_.ActionOf({group, ActionDirection::kForward, false}).model;
  const auto order = ArgumentsOf(model.roles, arguments, types);
  if (!order) return;
  std::vector<int> wide;
  for (const size_t argument : *order) wide.push_back(arguments[argument].type);
  learner_.Widen(group, wide);
}

void Learning::OnRecord(const std::string& name, const ActionModels& actions) {
  has_news_ = true;
  if (requested_.erase(name) > 0) return;  // the answer to its own request
  const ActionModel* model = Find(actions, name);
  if (model != nullptr && model->sec) {
    learner_.Know(name, *model->sec);
  } else {
    learner_.Forget(name);
  }
}

void Learning::OnDemonstrationEnd() {
  keeps_confirmations_ = true;
  has_news_ = true;
}

std::vector<ActionRecord> Learning::TakeChanges(const ActionModels& actions) {
  std::vector<ActionRecord> changes;
  if (!std::exchange(has_news_, false)) return changes;
  const bool keeps_confirmations = std::exchange(keeps_confirmations_, false);
  for (const std::string& name : std::exchange(renamed_, {})) {
    const ActionModel* known = Find(actions, name);
    if (known == nullptr || !known->sec) continue;
    requested_.insert(name);
    changes.push_back(Removed(WriteActionModel(*known, actions.domain())));
  }
  for (const SecLearner::Action& action : learner_.Actions()) {
    if (requested_.contains(action.name)) continue;
    if (auto change = ChangeOf(action, actions, keeps_confirmations)) {
      requested_.insert(action.name);
      changes.push_back(*std::move(change));
    }
  }
  return changes;
}

std::optional<ActionRecord> Learning::ChangeOf(
    const SecLearner::Action& learned, const ActionModels& actions,
    bool keeps_confirmations) const {
  const ActionModel* known = Find(actions, learned.name);
  ActionModel model;
  if (known != nullptr) {
    model = *known;
    ++model.version;
  }
  if (model.action.agents.empty()) {
    model.action = ActionOf(learned);
    model.skill_settings =
        model.action.skill ? SettingsOf(*model.action.skill) : "";
  }
  const auto fitted = FitToArguments(learned.model, model.action.arguments,
                                     actions.domain().vocabulary().types());
  if (!fitted ||
      (model.sec && fitted->SaysTheSame(*model.sec) &&
       (!keeps_confirmations || fitted->shown == model.sec->shown))) {
    return std::nullopt;
  }
  model.sec = *fitted;
  return WriteActionModel(model, actions.domain());
}

}  // namespace cell::recognizer
