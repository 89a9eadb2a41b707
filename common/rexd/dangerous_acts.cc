#include "common/rexd/dangerous_acts.h"

#include <algorithm>

namespace cell::rexd {

using namespace rules;

DangerousActs::DangerousActs(const RexdTask& task)
    : task_(&task), dead_ends_(task) {}

void DangerousActs::SetTask(const RexdTask& task) {
  task_ = &task;
  episode_.clear();
  dead_ends_ = DeadEndMemory(task);
}

DangerousActs::Effect DangerousActs::EffectOf(
    const Experience& experience) const {
  Effect effect;
  const World& world = *task_->world;
  const auto code_of = [&](int object) {
    const auto& arguments = experience.act.arguments;
    const auto it = std::ranges::find(arguments, object);
    return it == arguments.end() ? -1 - object
                                 : static_cast<int>(it - arguments.begin());
  };
  for (size_t s = 0; s < world.symbols().all().size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (!world.symbols()[symbol].is_primitive_predicate()) continue;
    for (int i = 0; i < world.num_places(symbol); ++i) {
      const int place = world.first(symbol) + i;
      const bool after = World::Get(experience.after, place);
      if (after == World::Get(experience.before, place)) continue;
      std::vector<int> objects = world.ObjectsAt(symbol, place);
      std::ranges::transform(objects, objects.begin(), code_of);
      effect.emplace_back(symbol, after, std::move(objects));
    }
  }
  return effect;
}

WorldState DangerousActs::Transfer(const Effect& effect, const GroundAct& act,
                                   WorldState state) const {
  const World& world = *task_->world;
  for (const auto& [symbol, is_true, codes] : effect) {
    std::vector<int> objects;
    for (const int code : codes) {
      objects.push_back(code < 0 ? -1 - code
                                 : act.arguments[static_cast<size_t>(code)]);
    }
    World::Set(&state, world.PlaceOf(symbol, objects), is_true);
  }
  world.Derive(&state);
  return state;
}

void DangerousActs::MarkEpisodeAlive() {
  for (const WorldState& state : episode_) dead_ends_.AddAlive(state);
  episode_.clear();
}

void DangerousActs::Observe(const Experience& experience,
                            bool is_demonstrated) {
  if (episode_.empty() || episode_.back() != experience.before) {
    episode_ = {experience.before};
  }
  if (is_demonstrated) MarkEpisodeAlive();
  episode_.push_back(experience.after);
  if (task_->IsGoal(experience.after)) MarkEpisodeAlive();
  if (experience.before != experience.after) {
    effects_[experience.act.action].insert(EffectOf(experience));
  }
}

void DangerousActs::RememberDeadEnd() {
  if (episode_.empty()) return;
  dead_ends_.AddDeadEnd(episode_.back());
  episode_.clear();
}

bool DangerousActs::IsDangerous(const GroundAct& act,
                                const WorldState& state) const {
  if (dead_ends_.empty()) return false;
  const auto effects = effects_.find(act.action);
  if (effects == effects_.end() || dead_ends_.LooksDead(state)) return false;
  return std::ranges::any_of(effects->second, [&](const Effect& effect) {
    return dead_ends_.LooksDead(Transfer(effect, act, state));
  });
}

}  // namespace cell::rexd
