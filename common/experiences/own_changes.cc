#include "common/experiences/own_changes.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace cell {

void ForEachDifference(
    const rules::WorldState& a, const rules::WorldState& b,
    const rules::World& world,
    const std::function<void(int symbol, int place)>& visit) {
  int symbol = 0;
  for (size_t w = 0; w < a.bits.size(); ++w) {
    for (uint64_t word = a.bits[w] ^ b.bits[w]; word != 0; word &= word - 1) {
      const int place = static_cast<int>(64 * w) + std::countr_zero(word);
      const auto is_of = [&](int s) {
        return world.symbols()[s].is_primitive_predicate() &&
               world.first(s) + world.num_places(s) > place;
      };
      while (!is_of(symbol)) ++symbol;
      visit(symbol, place);
    }
  }
}

rules::Experience OwnChanges(const rules::Experience& experience,
                             const RuleWorld& world) {
  const rules::World& w = *world.world();
  rules::Experience own = experience;
  const auto is_own = [&](int object) {
    return std::ranges::count(experience.act.arguments, object) > 0;
  };
  ForEachDifference(
      experience.before, experience.after, w, [&](int symbol, int place) {
        if (std::ranges::all_of(w.ObjectsAt(symbol, place), is_own)) return;
        rules::World::Set(&own.after, place,
                          rules::World::Get(experience.before, place));
      });
  return own;
}

rules::Experience Reversed(const rules::Experience& experience, int action) {
  return {
      experience.after, {action, experience.act.arguments}, experience.before};
}

}  // namespace cell
