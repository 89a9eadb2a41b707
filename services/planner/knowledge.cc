#include "services/planner/knowledge.h"

#include <utility>

#include "common/actions/action_model_reader.h"
#include "common/experiences/learned_actions.h"
#include "common/task/task_actions.h"

namespace cell::planner {

Knowledge::Knowledge(Domain domain, bool is_learning)
    : domain_(std::move(domain)),
      is_learning_(is_learning),
      experiences_(std::make_shared<const Experiences>()) {}

void Knowledge::SetModels(ActionModels models) {
  models_ = std::move(models);
  SecModels by_name;
  for (const ActionModel& model : models_->models()) {
    if (model.sec) by_name.emplace(model.action.name, *model.sec);
  }
  sec_models_ = std::make_shared<const SecModels>(std::move(by_name));
}

void Knowledge::Put(const ActionRecord& record) {
  // The recognizer reports a record whose event chain makes no sense.
  if (models_) {
    const auto update = models_->Apply(record);
    if (update && *update == ActionModels::Update::kChanged) {
      SetModels(*std::exchange(models_, std::nullopt));
    }
  }
  if (!domain_.Put(ReadAction(record, domain_))) return;
  source_ = record.name;
  has_changed_ = true;
}

void Knowledge::Add(int64_t id, const TaskExperience& experience) {
  if (!is_learning_ || !by_id_.emplace(id, experience).second) return;
  source_ = experience.action;
  has_changed_ = true;
}

void Knowledge::Remove(int64_t id) {
  if (by_id_.erase(id) > 0) has_changed_ = true;
}

std::shared_ptr<const RuleSet> Knowledge::TakeChange(int64_t version) {
  if (!std::exchange(has_changed_, false)) return nullptr;
  if (by_id_.empty()) {
    experiences_ = std::make_shared<const Experiences>();
    return RuleSet::FromDomain(domain_, source_, version);
  }
  Experiences all;
  for (const auto& [id, experience] : by_id_) all.push_back(experience);
  experiences_ = std::make_shared<const Experiences>(std::move(all));
  return RuleSet::FromDomain(WithLearnedRules(), source_, version);
}

Domain Knowledge::WithLearnedRules() {
  Domain domain = domain_;
  const auto actions =
      LearnActions(*experiences_, domain.actions(), domain.goals(),
                   std::make_shared<const Vocabulary>(domain.vocabulary()));
  why_not_.reset();
  if (!actions) {
    why_not_ = actions.reason();
    return domain;
  }
  for (const Action& action : *actions) domain.Put(action);
  CompleteActions({}, &domain);
  return domain;
}

}  // namespace cell::planner
