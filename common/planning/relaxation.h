#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "common/planning/ground_task.h"
#include "common/planning/model.h"

namespace cell::planning {

/// The delete relaxation of a task: every outcome can be chosen, and a literal
/// that was once reached stays available; true and false literals alike.
class Relaxation {
 public:
  explicit Relaxation(const GroundTask& task);

  /// Explores the relaxation from a state: max_probability is 0 if the goal is
  /// not reached, least_actions is h_max, distance follows h_add. Then clears
  /// the atoms of the state on which nothing depends that can still happen on
  /// the way to the goal, but for those that keep an operator from ever
  /// applying. So the best policies from the state stay the same.
  Estimate Assess(std::span<uint64_t> state) const;

 private:
  /// Effects of an action that have the same condition.
  struct Operator {
    std::vector<int> facts;  ///< what must be reached
    std::vector<int> atoms;  ///< that the facts depend on
    std::vector<int> added;  ///< facts
  };
  /// Lists by index, in one array.
  struct Lists {
    std::vector<int> begin;
    std::vector<int> items;
    std::span<const int> Of(int index) const {
      const auto i = static_cast<size_t>(index);
      return std::span(items).subspan(
          static_cast<size_t>(begin[i]),
          static_cast<size_t>(begin[i + 1] - begin[i]));
    }
  };
  struct Indices {
    Lists clauses_with;        ///< by fact: facts of clauses
    Lists operators_needing;   ///< by fact
    Lists operators_changing;  ///< by atom; the goal's last
    Lists facts_of;            ///< by operator
    Lists added_by;            ///< by operator; only facts that are needed
    Lists atoms_of;            ///< by operator
  };
  /// What the last exploration has reached; used again by the next one.
  struct Exploration {
    std::vector<int> num_missing;       ///< facts of each operator
    std::vector<double> operator_cost;  ///< of its facts reached so far
    std::vector<int> layer;             ///< of each fact; -1: not reached
    std::vector<double> cost;           ///< of each fact
    std::vector<int> queue;             ///< facts in the order of their layers
    std::vector<uint64_t> relevant;     ///< atoms, as the bits of a state
    std::vector<char> is_seen;          ///< by operator
  };
  static Lists Flatten(const std::vector<std::vector<int>>& lists);

  int FactOfClause(const std::vector<Literal>& clause);
  Operator OperatorOf(const Conjunction& condition);
  void AddOperators(const GroundAction& action);
  void Index();
  void MarkNeeded(const std::vector<std::vector<int>>& needing,
                  const std::vector<std::vector<int>>& clauses);
  void Reach(int fact, int layer, double cost) const;
  void ReachOne(int fact, int layer, double cost) const;
  void ReachAll(Bits state) const;
  void Fire(int op, int layer) const;
  void MarkRelevant() const;
  void KeepBlocked() const;
  void Keep(int fact) const;

  int num_atoms_;
  int num_facts_;  // 2 of each atom, then clauses
  int goal_fact_ = 0;
  std::map<std::vector<Literal>, int> fact_of_clause_;
  std::vector<Operator> operators_;
  std::vector<int> num_needed_;            // facts of each operator
  std::vector<int> always_;                // operators that need nothing
  std::vector<int> needing_false_;         // operators that an atom could block
  std::vector<std::vector<int>> clauses_;  // literals as facts
  std::vector<char> is_needed_;            // by fact: some operator needs it
  std::vector<int> needed_atoms_;          // with a fact that is needed
  Indices indices_;
  mutable Exploration last_;
};

}  // namespace cell::planning
