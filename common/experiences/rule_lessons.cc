#include "common/experiences/rule_lessons.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/experiences/effects_on_others.h"
#include "common/experiences/own_changes.h"
#include "common/rules/learning/learner.h"

namespace cell {
namespace {

using rules::Experience;

/// Of an action with so many experiences, one or two alone make no rule.
constexpr int kManyExperiences = 40;
constexpr int kFewExperiences = 2;

/// Without rules of few experiences among many of the action, whose rules these
/// are.
void DropRare(std::vector<int>* counts, std::vector<rules::Rule>* rules) {
  int num_experiences = 0;
  for (const int count : *counts) num_experiences += count;
  if (num_experiences < kManyExperiences) return;
  for (size_t i = counts->size(); i-- > 0;) {
    if ((*counts)[i] > kFewExperiences) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    rules->erase(rules->begin() + at);
    counts->erase(counts->begin() + at);
  }
}

void MakeUnsure(const std::vector<int>& counts,
                std::vector<rules::Rule>* rules) {
  for (size_t i = 0; i < rules->size(); ++i) {
    rules::Rule& rule = (*rules)[i];
    const double share = counts[i] / (counts[i] + 1.0);
    double sum = 0;
    for (rules::Outcome& outcome : rule.outcomes) {
      outcome.probability *= share;
      sum += outcome.probability;
    }
    rule.noise = 1 - sum;
  }
}

}  // namespace

std::vector<int> GoalPredicates(std::span<const Goal> goals) {
  std::set<int> predicates;
  for (const Goal& goal : goals) {
    for (const Literal& literal : goal.literals) {
      predicates.insert(literal.relation);
    }
  }
  return {predicates.begin(), predicates.end()};
}

RuleLessons::RuleLessons(std::shared_ptr<const RuleWorld> world,
                         std::span<const int> goal_predicates,
                         int num_for_others)
    : world_(std::move(world)),
      goal_predicates_(goal_predicates.begin(), goal_predicates.end()),
      num_for_others_(num_for_others),
      specialization_(world_->world(),
                      ParamsOf(goal_predicates, num_for_others)) {
  for (const int action : this->world().symbols().Actions()) lessons_[action];
}

Specialization::Params RuleLessons::ParamsOf(
    std::span<const int> goal_predicates, int num_for_others) const {
  Specialization::Params params{{}, num_for_others};
  const auto& predicates = world_->vocabulary().predicates();
  for (const int predicate : goal_predicates) {
    params.landmarks.push_back(*world().symbols().Find(
        predicates[static_cast<size_t>(predicate)].name));
  }
  return params;
}

void RuleLessons::Add(int64_t id, const Experience& experience) {
  const int action = experience.act.action;
  if (!action_of_id_.emplace(id, action).second) {
    throw std::invalid_argument("the experience " + std::to_string(id) +
                                " is there already");
  }
  lessons_.at(action).done.emplace(id, experience);
  Open(action);
}

void RuleLessons::Remove(int64_t id) {
  const auto found = action_of_id_.find(id);
  if (found == action_of_id_.end()) return;
  const int action = found->second;
  action_of_id_.erase(found);
  lessons_.at(action).done.erase(id);
  Open(action);
}

void RuleLessons::SetWorld(std::shared_ptr<const RuleWorld> world) {
  const auto& before = this->world().symbols().all();
  const auto& after = world->world()->symbols().all();
  bool is_same = before.size() <= after.size() &&
                 this->world().objects() == world->world()->objects();
  for (size_t i = 0; is_same && i < before.size(); ++i) {
    is_same = before[i].name == after[i].name &&
              before[i].arity == after[i].arity &&
              before[i].kind == after[i].kind;
  }
  if (!is_same) {
    throw std::invalid_argument("the symbols do not keep their places");
  }
  std::map<int, std::optional<int>> undone;
  for (const auto& [action, lesson] : lessons_) {
    undone[action] = UndoneBy(action);
  }
  world_ = std::move(world);
  specialization_ = Specialization(world_->world(),
                                   ParamsOf(goal_predicates_, num_for_others_));
  bindings_.clear();
  for (const int action : this->world().symbols().Actions()) {
    const bool is_new = !undone.contains(action);
    Lesson& lesson = lessons_[action];
    if (is_new || undone.at(action) != UndoneBy(action)) lesson.is_open = true;
  }
}

std::optional<int> RuleLessons::UndoneBy(int action) const {
  const auto& actions = world_->actions();
  const auto undone =
      actions[static_cast<size_t>(world_->ActionOf(action))].undoes;
  if (!undone) return std::nullopt;
  return world().symbols().Find(actions[static_cast<size_t>(*undone)].name);
}

/// It has to be learned again, and what is learned from its reversed
/// experiences.
void RuleLessons::Open(int action) {
  for (auto& [other, lesson] : lessons_) {
    if (other == action || (lesson.done.empty() && UndoneBy(other) == action)) {
      lesson.is_open = true;
    }
  }
}

RuleLessons::Experiences RuleLessons::ExperiencesOf(int action) const {
  Experiences experiences;
  const auto& done = lessons_.at(action).done;
  for (const auto& [id, experience] : done) experiences.push_back(experience);
  const std::optional<int> undone = UndoneBy(action);
  if (!experiences.empty() || !undone) return experiences;
  for (const auto& [id, experience] : lessons_.at(*undone).done) {
    experiences.push_back(Reversed(experience, action));
  }
  return experiences;
}

RuleLessons::Experiences RuleLessons::OwnOf(
    const Experiences& experiences) const {
  Experiences own;
  for (const Experience& e : experiences) {
    own.push_back(OwnChanges(e, *world_));
  }
  return own;
}

/// What follows from the action's own experiences only.
void RuleLessons::LearnAlone(int action, Lesson* lesson) const {
  const Experiences own = OwnOf(ExperiencesOf(action));
  const rules::QuantifiedAtoms& atoms = specialization_.atoms();
  lesson->seen.emplace(atoms.size());
  rules::Learner learner(world_->world(), rules::LearnerOptions());
  for (const Experience& e : own) {
    learner.Add(e);
    lesson->seen->Add(atoms.TrueIn(e.before));
    lesson->seen->Add(atoms.TrueIn(e.after));
  }
  learner.Learn();
  lesson->learned = learner.Rules().rules;
  std::vector<int> counts = learner.RuleCounts();
  DropRare(&counts, &lesson->learned);
  MakeUnsure(counts, &lesson->learned);
}

/// @param seen  in the experiences of all actions
void RuleLessons::Finish(int action, const SeenAtoms& seen,
                         Lesson* lesson) const {
  const Experiences all = ExperiencesOf(action);
  const Experiences own = OwnOf(all);
  std::vector<rules::Rule> specialized = lesson->learned;
  for (rules::Rule& rule : specialized) {
    specialization_.Apply(own, bindings_.at(action), seen, &rule);
  }
  if (!lesson->is_open && specialized == lesson->specialized) return;
  lesson->specialized = specialized;
  lesson->rules = std::move(specialized);
  for (rules::Rule& rule : lesson->rules) {
    AddEffectsOnOthers(all, specialization_.landmarks(), *world_, &rule);
  }
}

/// Types are the same in all states, and so is what they allow.
void RuleLessons::FindBindings(const rules::WorldState& state) {
  for (rules::GroundAct& act : rules::GroundActs(world(), state)) {
    bindings_[act.action].push_back(std::move(act.arguments));
  }
}

rules::NdrRules RuleLessons::Learn() {
  SeenAtoms seen(specialization_.atoms().size());
  for (auto& [action, lesson] : lessons_) {
    if (bindings_.empty() && !lesson.done.empty()) {
      FindBindings(lesson.done.begin()->second.before);
    }
    if (lesson.is_open) LearnAlone(action, &lesson);
    if (lesson.seen) seen.Add(*lesson.seen);
  }
  const bool was_seen = seen_ == seen;
  seen_ = seen;
  rules::NdrRules rules{world_->world()->shared_symbols(), {}};
  for (auto& [action, lesson] : lessons_) {
    if (lesson.is_open || !was_seen) Finish(action, seen, &lesson);
    lesson.is_open = false;
    rules.rules.insert(rules.rules.end(), lesson.rules.begin(),
                       lesson.rules.end());
  }
  return rules;
}

rules::NdrRules LearnRules(std::span<const Experience> experiences,
                           std::span<const int> goal_predicates,
                           const RuleWorld& world, int num_for_others) {
  RuleLessons lessons(std::make_shared<const RuleWorld>(world), goal_predicates,
                      num_for_others);
  int64_t id = 0;
  for (const Experience& e : experiences) lessons.Add(id++, e);
  return lessons.Learn();
}

}  // namespace cell
