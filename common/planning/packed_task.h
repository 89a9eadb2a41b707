#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/planning/ground_task.h"
#include "common/planning/model.h"

namespace cell::planning {

/// The conditions and effects of a task as masks of words.
class PackedTask {
 public:
  /// @throws std::invalid_argument for atoms that are not there and for
  /// probabilities that are negative or exceed 1 in sum
  explicit PackedTask(const GroundTask& task);

  int num_words() const { return num_words_; }
  bool IsGoal(Bits state) const;
  void Expand(Bits state, Expansion* expansion) const;

 private:
  /// Bits of a word that have to be set, and clear; of a clause one of them.
  struct Mask {
    size_t word;
    uint64_t set;
    uint64_t clear;
  };
  struct Range {
    size_t begin = 0;
    size_t end = 0;
  };
  struct Condition {
    Range masks;
    Range clauses;
  };
  struct Effect {
    Condition when;
    Range changes;  ///< masks
  };
  struct Outcome {
    double probability;
    Range effects;
  };
  struct Action {
    Condition precondition;
    Range outcomes;
    double rest;  ///< probability that nothing changes
  };

  Range PackMasks(const std::vector<Literal>& literals, bool are_changes);
  Condition Pack(const Conjunction& conjunction);
  Effect Pack(const ConditionalEffect& effect);
  Action Pack(const GroundAction& action);
  bool Holds(const Condition& condition, Bits state) const;
  void Apply(const Outcome& outcome, Bits before,
             std::span<uint64_t> after) const;

  int num_atoms_;
  int num_words_;
  std::vector<Mask> masks_;
  std::vector<Range> clauses_;
  std::vector<Effect> effects_;
  std::vector<Outcome> outcomes_;
  std::vector<Action> actions_;
  std::vector<Condition> goals_;
};

}  // namespace cell::planning
