#include "services/planner/knowledge.h"

#include <utility>

#include "common/actions/action_model_reader.h"
#include "common/task/task_actions.h"

namespace cell::planner {

Knowledge::Knowledge(Domain domain, bool is_learning,
                     std::span<const TaskExperience> shipped)
    : domain_(std::move(domain)),
      experiences_(std::make_shared<const Experiences>()) {
  if (!is_learning) return;
  learned_.emplace(domain_.actions(), domain_.goals(),
                   std::make_shared<const Vocabulary>(domain_.vocabulary()));
  // The library's ids are positive.
  int64_t id = -std::ssize(shipped);
  for (const TaskExperience& experience : shipped) {
    has_changed_ |= learned_->Add(id++, experience);
  }
  if (has_changed_) WithLearnedRules();
}

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
  if (learned_) learned_->SetActions(domain_.actions());
  source_ = record.name;
  has_changed_ = true;
}

void Knowledge::Add(int64_t id, const TaskExperience& experience) {
  if (!learned_ || !learned_->Add(id, experience)) return;
  source_ = experience.action;
  has_changed_ = true;
}

void Knowledge::Remove(int64_t id) {
  if (learned_ && learned_->Remove(id)) has_changed_ = true;
}

std::shared_ptr<const RuleSet> Knowledge::TakeChange(int64_t version) {
  if (!std::exchange(has_changed_, false)) return nullptr;
  Experiences all;
  if (learned_) {
    for (const auto& [id, experience] : learned_->experiences()) {
      all.push_back(experience);
    }
  }
  experiences_ = std::make_shared<const Experiences>(std::move(all));
  return RuleSet::FromDomain(
      experiences_->empty() ? domain_ : WithLearnedRules(), source_, version);
}

Domain Knowledge::WithLearnedRules() {
  Domain domain = domain_;
  const auto actions = learned_->Learn();
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
