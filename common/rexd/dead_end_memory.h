#pragma once

#include <compare>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// What dead ends have in common, learned from states of which it is known
/// whether the goal can be reached from them (section VI-B1).
///
/// A nogood (Kolobov, Mausam, Weld, AAAI 2010) is a conjunction of facts, of
/// whatever objects, that holds in a dead end and in no state from which the
/// goal can be reached. All nogoods of one fact are kept; if there are none,
/// all of two facts; if there are none of these either, the state itself. What
/// the rules say plays no part: a young learner's rules are too general to
/// explain a dead end.
class DeadEndMemory {
 public:
  /// @param task  must outlive this
  explicit DeadEndMemory(const RexdTask& task);

  /// The goal was reached from the state, or can be.
  void AddAlive(const rules::WorldState& state);
  /// The goal cannot be reached from the state.
  void AddDeadEnd(const rules::WorldState& state);

  bool empty() const { return dead_ends_.empty(); }
  /// True if a nogood holds in the state, or if it is a known dead end.
  bool LooksDead(const rules::WorldState& state) const;
  /// The nogoods, one a line: "broken(X)", "closed() and missing placed(X)".
  std::string ToText() const;

 private:
  enum class FactKind {
    kHolds,   ///< an atom
    kUndone,  ///< an atom of the start that does not hold
    kMissing  ///< a literal of the goal that does not hold
  };
  /// Objects are numbers of the world's objects; in a nogood, those that are
  /// no constants are variables, from num_objects on.
  struct Fact {
    FactKind kind = FactKind::kHolds;
    int symbol = 0;
    std::vector<int> objects;
    auto operator<=>(const Fact&) const = default;
  };
  using Nogood = std::vector<Fact>;
  using Facts = std::map<std::pair<FactKind, int>, std::vector<Fact>>;
  struct DeadEnd {
    rules::WorldState state;
    std::vector<Nogood> nogoods;
  };

  Facts FactsOf(const rules::WorldState& state) const;
  Facts FactsOfGoal() const;
  bool Matches(const Nogood& nogood, const Facts& facts) const;
  bool MatchesFrom(const Nogood& nogood, size_t next, const Facts& facts,
                   std::map<int, int>* binding) const;
  bool IsRefuted(const Nogood& nogood) const;
  std::string Show(const Nogood& nogood) const;
  void FindNogoods(DeadEnd* dead_end) const;

  const RexdTask* task_;
  std::set<std::vector<uint64_t>> alive_;
  std::vector<Facts> alive_facts_;
  std::vector<DeadEnd> dead_ends_;
};

}  // namespace cell::rexd
