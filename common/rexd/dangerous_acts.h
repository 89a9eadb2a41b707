#pragma once

#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "common/rexd/dead_end_memory.h"
#include "common/rules/experience.h"

namespace cell::rexd {

/// Which actions may lead to a dead end, learned from experiences: those that
/// have ever, with whatever objects, changed what would now lead to a state
/// that looks like a dead end. How often it has happened does not matter.
class DangerousActs {
 public:
  /// @param task  must outlive this
  explicit DangerousActs(const RexdTask& task);

  /// Goes on in another task of the same world. What actions do is remembered;
  /// dead ends are those of a goal and are forgotten.
  /// @param task  must outlive this
  void SetTask(const RexdTask& task);

  /// An experience that does not begin where the last one has ended begins an
  /// episode.
  /// @param is_demonstrated  by the teacher, which shows something only where
  ///     there is a way to the goal
  void Observe(const rules::Experience& experience, bool is_demonstrated);
  /// The goal cannot be reached from the state after the last experience.
  void RememberDeadEnd();

  const DeadEndMemory& dead_ends() const { return dead_ends_; }
  /// False for all acts of a state that looks like a dead end itself.
  bool IsDangerous(const rules::GroundAct& act,
                   const rules::WorldState& state) const;

 private:
  /// An atom that an experience changed: symbol, truth afterwards, and
  /// objects. Of an argument of the action its place, of others -1 - object.
  using Change = std::tuple<int, bool, std::vector<int>>;
  using Effect = std::vector<Change>;

  void MarkEpisodeAlive();
  Effect EffectOf(const rules::Experience& experience) const;
  /// The state after the same has happened to the objects of another action.
  rules::WorldState Transfer(const Effect& effect, const rules::GroundAct& act,
                             rules::WorldState state) const;

  const RexdTask* task_;
  std::map<int, std::set<Effect>> effects_;  // by action
  std::vector<rules::WorldState> episode_;   // not known to be alive yet
  DeadEndMemory dead_ends_;
};

}  // namespace cell::rexd
