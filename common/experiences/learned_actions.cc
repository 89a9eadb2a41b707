#include "common/experiences/learned_actions.h"

#include <algorithm>
#include <set>
#include <utility>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_world.h"
#include "common/relational/ground_action.h"

namespace cell {
namespace {

/// What was never shown otherwise is not relied on.
constexpr int kNumForOthers = 1;

/// True if the actions begin with those.
bool KeepTheirPlaces(std::span<const Action> those,
                     std::span<const Action> actions) {
  return those.size() <= actions.size() &&
         std::ranges::equal(those, actions.first(those.size()),
                            [](const Action& a, const Action& b) {
                              return a.name == b.name && a.TakesArgumentsOf(b);
                            });
}

}  // namespace

LearnedActions::LearnedActions(std::span<const Action> actions,
                               std::span<const Goal> goals,
                               std::shared_ptr<const Vocabulary> vocabulary)
    : vocabulary_(std::move(vocabulary)),
      goal_predicates_(GoalPredicates(goals)),
      world_(std::make_shared<const RuleWorld>(vocabulary_, actions)),
      lessons_(world_, goal_predicates_, kNumForOthers) {}

void LearnedActions::SetActions(std::span<const Action> actions) {
  std::set<int64_t> taught;
  const bool is_kept = KeepTheirPlaces(world_->actions(), actions);
  for (const auto& [id, experience] : experiences_) {
    if (is_kept && ActionOf(experience)) taught.insert(id);
  }
  world_ = std::make_shared<const RuleWorld>(vocabulary_, actions);
  if (is_kept) {
    lessons_.SetWorld(world_);
  } else {
    lessons_ = RuleLessons(world_, goal_predicates_, kNumForOthers);
    counts_.clear();
  }
  for (const auto& [id, experience] : experiences_) {
    if (!taught.contains(id)) Teach(id, experience);
  }
}

bool LearnedActions::Add(int64_t id, const TaskExperience& experience) {
  if (!experiences_.emplace(id, experience).second) return false;
  Teach(id, experience);
  return true;
}

bool LearnedActions::Remove(int64_t id) {
  const auto found = experiences_.find(id);
  if (found == experiences_.end()) return false;
  if (const auto ground = ActionOf(found->second)) {
    counts_.erase(ground->action);
    lessons_.Remove(id);
  }
  experiences_.erase(found);
  return true;
}

/// The experience's action; nullopt unless it takes these objects.
std::optional<GroundAction> LearnedActions::ActionOf(
    const TaskExperience& experience) const {
  const std::vector<Action>& actions = world_->actions();
  const auto place = FindAction(actions, experience.action);
  if (!place) return std::nullopt;
  const auto& arguments = actions[static_cast<size_t>(*place)].arguments;
  if (arguments.size() != experience.objects.size()) return std::nullopt;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (!vocabulary_->IsOf(experience.objects[i], arguments[i].type)) {
      return std::nullopt;
    }
  }
  return GroundAction{*place, experience.objects};
}

void LearnedActions::Teach(int64_t id, const TaskExperience& experience) {
  const auto ground = ActionOf(experience);
  if (!ground) return;
  counts_.erase(ground->action);
  lessons_.Add(
      id, world_->ToExperience(experience.before, *ground, experience.after));
}

Result<std::vector<Action>> LearnedActions::Learn() {
  auto learned = WithLearnedRules(lessons_.Learn(), *world_);
  if (!learned) return learned;
  std::vector<Action> actions = *std::move(learned);
  CountExperiences(&actions);
  return actions;
}

/// Sets how many experiences each rule covers.
void LearnedActions::CountExperiences(std::vector<Action>* actions) {
  std::set<int> to_count;
  for (size_t i = 0; i < actions->size(); ++i) {
    const Action& action = (*actions)[i];
    Count& count = counts_[static_cast<int>(i)];
    if (count.rules == action.rules &&
        count.numbers.size() == action.rules.size()) {
      continue;
    }
    count = {action.rules, std::vector<int>(action.rules.size())};
    to_count.insert(static_cast<int>(i));
  }
  for (const auto& [id, experience] : experiences_) {
    const auto ground = ActionOf(experience);
    if (!ground || !to_count.contains(ground->action)) continue;
    const Action& action = (*actions)[static_cast<size_t>(ground->action)];
    const State before = experience.before.UnknownAsFalse();
    for (const ApplicableRule& applicable :
         ApplicableRules(action, ground->arguments, before, *vocabulary_,
                         action.agents.front())) {
      ++counts_.at(ground->action)
            .numbers[static_cast<size_t>(applicable.rule)];
    }
  }
  for (size_t i = 0; i < actions->size(); ++i) {
    const Count& count = counts_.at(static_cast<int>(i));
    for (size_t r = 0; r < count.numbers.size(); ++r) {
      (*actions)[i].rules[r].num_experiences = count.numbers[r];
    }
  }
}

}  // namespace cell
