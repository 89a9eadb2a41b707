#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/planning/model.h"

namespace cell::planning {

/// Bounds of a value.
struct Interval {
  double low = 0;
  double high = 1;
  double width() const { return high - low; }
  bool operator==(const Interval&) const = default;
};

struct Step {
  int action = 0;
  std::string name;
  double probability = 0;  ///< of the outcome that the course goes on with
  bool operator==(const Step&) const = default;
};

/// A first action, and what can be reached when it is done first.
struct Alternative {
  int action = 0;
  std::string name;
  Interval probability;
  bool operator==(const Alternative&) const = default;
};

/// The best way to the goal: the highest probability of reaching it, then the
/// fewest actions to be expected.
struct Plan {
  enum class Status {
    kFound,
    kGoalReached,  ///< already
    kNoPlan,       ///< proven: the goal cannot be reached
    kUndecided     ///< the budget ended before a way was found
  };
  Status status = Status::kUndecided;
  std::string reason;  ///< in plain words, unless a plan is found
  /// The best policy's probability of reaching the goal lies between these; the
  /// plan at hand reaches it with at least the lower one.
  Interval probability;
  /// Of the plan at hand, given that the goal is reached.
  double expected_actions = 0;
  /// True if no best policy needs fewer.
  bool is_shortest = false;
  std::vector<Step> course;               ///< the most likely one
  std::vector<Alternative> alternatives;  ///< at the start, best first
  int64_t num_expansions = 0;             ///< of this call
  int64_t num_states = 0;                 ///< that the planner knows
  int64_t num_bytes = 0;                  ///< that it holds them in
  bool operator==(const Plan&) const = default;
};

/// Finds the policy of the highest probability of reaching the goal (MaxProb)
/// and, among those, of the least expected number of actions given that the
/// goal is reached (S3P: Teichteil-Koenigsbuch, AAAI 2012).
///
/// Depth-first heuristic search with a lower and an upper bound for each state.
/// End components in which the upper bound would get caught are collapsed
/// (FRET: Kolobov et al., ICAPS 2011; Haddad and Monmege, TCS 2018). Keeps what
/// it has found out for later questions.
class Planner {
 public:
  struct Params {
    /// States whose successors are computed, in one call of Find().
    int64_t max_expansions = 10'000'000;
    /// Ends the search like max_expansions.
    int64_t max_bytes = int64_t{1000} << 20;
    /// Width of the interval of the probability that is good enough.
    double precision = 1e-9;
    /// Whether to look for the fewest actions among the best policies, and
    /// with how many further expansions.
    bool minimize_actions = true;
    int64_t max_minimize_expansions = INT64_MAX;
    /// Alternatives get intervals of `precision`, too.
    bool solve_alternatives = false;
  };

  Planner(std::shared_ptr<const Model> model, const Params& params);
  ~Planner();

  /// How far a search has come.
  struct Progress {
    int64_t num_expansions = 0;
    Interval probability;
    /// It ends here: all is found, or the budget is spent.
    bool is_last = false;
  };
  /// Told between two passes, when the search can be saved; false stops it, as
  /// a spent budget does.
  using Watch = std::function<bool(const Progress&)>;

  /// The best plan from a state.
  /// @param state  as many words as the model's states have
  /// @throws std::invalid_argument for another number of words
  Plan Find(Bits state, const Watch& watch = {});

  /// Writes all that is known; to be called by a Watch or after Find().
  void Save(std::ostream* out) const;
  /// Reads what a planner of an equal model has saved, before the first Find():
  /// which goes on as if it had not been interrupted, if it is asked for the
  /// same state and precision. Expansions then count from the beginning.
  /// @param num_bytes  of the stream's rest
  /// @throws std::runtime_error for anything else or for damage ("is damaged");
  /// the planner is of no use then
  void Restore(std::istream* in, uint64_t num_bytes);

  /// What the plan found last does in a state: the action; nullopt where it
  /// does nothing (a goal, a dead end, a state that it does not lead to).
  std::optional<int> ActionIn(Bits state) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace cell::planning
