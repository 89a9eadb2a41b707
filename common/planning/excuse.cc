#include "common/planning/excuse.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "common/planning/goal_search.h"
#include "common/planning/ground_model.h"
#include "common/planning/regression.h"

namespace cell::planning {
namespace {

constexpr size_t kMaxNeededBy = 3;

using Changes = std::vector<Literal>;  // ascending

class ExcuseSearch {
 public:
  ExcuseSearch(const GroundTask& task, const ExcuseOptions& options)
      : task_(task),
        options_(options),
        model_(std::make_shared<GroundModel>(task)),
        goal_search_(model_) {
    for (const Conjunction& goal : task.goals) {
      wished_.insert(goal.literals.begin(), goal.literals.end());
      for (const auto& clause : goal.clauses) {
        wished_.insert(clause.begin(), clause.end());
      }
    }
  }

  Excuses Find() {
    Excuses result;
    result.is_solvable = Helps({});
    result.is_minimal = true;
    if (!result.is_solvable) {
      for (const bool may_wish : {false, true}) {
        may_wish_ = may_wish;
        if (FindSmallest()) break;
      }
      result.is_minimal = !was_cut_;
    }
    for (const Changes& changes : found_) {
      result.excuses.push_back(ExcuseOf(changes));
    }
    std::ranges::stable_sort(result.excuses, {}, [](const Excuse& excuse) {
      return std::ranges::count(excuse.changes, true,
                                &RequiredChange::has_producer);
    });
    result.num_trials = num_trials_;
    return result;
  }

 private:
  bool MayChange(const Literal& literal) const {
    if (!may_wish_ && wished_.contains(literal)) return false;
    return !options_.may_change || options_.may_change(literal);
  }

  /// Tries all sets of 1, 2, ... changes; true once one helps.
  bool FindSmallest() {
    for (int size = 1; size <= options_.max_changes; ++size) {
      tried_.clear();
      Extend({}, size);
      if (!found_.empty()) return true;
    }
    return false;
  }

  void Extend(const Changes& changes, int size) {
    if (IsFull()) return;
    const Regression reached(task_, changes);
    const bool has_goal = reached.HasGoal();
    if (static_cast<int>(changes.size()) == size) {
      if (has_goal && Helps(changes)) found_.push_back(changes);
      return;
    }
    // Beyond the relaxation any change might help.
    for (const Literal& l : has_goal ? AllChanges() : reached.Missing()) {
      const bool is_new =
          task_.initial[static_cast<size_t>(l.atom)] != l.value &&
          std::ranges::find(changes, l) == changes.end();
      if (!is_new || !MayChange(l)) continue;
      Changes more = changes;
      more.insert(std::ranges::upper_bound(more, l), l);
      if (tried_.insert(more).second) Extend(more, size);
    }
  }

  bool IsFull() {
    if (static_cast<int>(found_.size()) >= options_.max_excuses) return true;
    if (++num_trials_ > options_.max_trials) was_cut_ = true;
    return num_trials_ > options_.max_trials;
  }

  Changes AllChanges() const {
    Changes all;
    for (size_t atom = 0; atom < task_.atoms.size(); ++atom) {
      all.push_back({static_cast<int>(atom), !task_.initial[atom]});
    }
    return all;
  }

  bool Helps(const Changes& changes) {
    std::vector<bool> state = task_.initial;
    for (const Literal& l : changes) {
      state[static_cast<size_t>(l.atom)] = l.value;
    }
    const auto answer =
        goal_search_.CanReachGoal(model_->Pack(state), options_.max_expansions);
    was_cut_ |= answer == GoalSearch::Answer::kUndecided;
    return answer == GoalSearch::Answer::kYes;
  }

  bool HasProducer(const Literal& literal) const {
    for (const GroundAction& action : task_.actions) {
      for (const Outcome& outcome : action.outcomes) {
        for (const ConditionalEffect& effect : outcome.effects) {
          if (std::ranges::find(effect.then, literal) != effect.then.end()) {
            return true;
          }
        }
      }
    }
    return false;
  }

  Excuse ExcuseOf(const Changes& changes) const {
    const Regression before(task_, {});
    const Regression after(task_, changes);
    Excuse excuse;
    for (const Literal& l : changes) {
      RequiredChange change{l, {}, HasProducer(l)};
      for (const GroundAction& action : task_.actions) {
        if (change.needed_by.size() == kMaxNeededBy) break;
        const bool is_there =
            std::ranges::find(change.needed_by, action.name) !=
            change.needed_by.end();
        if (!is_there && after.AppliesBy(action, l)) {
          change.needed_by.push_back(action.name);
        }
      }
      excuse.changes.push_back(std::move(change));
    }
    excuse.subgoals = after.SubgoalsWithin(before);
    return excuse;
  }

  const GroundTask& task_;
  const ExcuseOptions& options_;
  std::shared_ptr<const GroundModel> model_;
  GoalSearch goal_search_;
  std::set<Literal> wished_;  // by the goal
  bool may_wish_ = false;
  bool was_cut_ = false;
  int64_t num_trials_ = 0;
  std::set<Changes> tried_;
  std::vector<Changes> found_;
};

std::string Explain(const RequiredChange& change, const GroundTask& task,
                    const Words& words) {
  const Literal opposite{change.literal.atom, !change.literal.value};
  std::string text;
  if (!change.needed_by.empty()) {
    text = change.needed_by.front() +
           " needs: " + Say(change.literal, task, words) + "; but ";
  }
  text += Say(opposite, task, words);
  return text + (change.has_producer ? "" : ", and no action changes that");
}

}  // namespace

Excuses FindExcuses(const GroundTask& task, const ExcuseOptions& options) {
  return ExcuseSearch(task, options).Find();
}

std::string Say(const Literal& literal, const GroundTask& task,
                const Words& words) {
  const GroundAtom& atom = task.atoms[static_cast<size_t>(literal.atom)];
  const auto found = words.find(atom.predicate);
  if (found == words.end()) return Show(literal, task.atoms);
  fmt::dynamic_format_arg_store<fmt::format_context> objects;
  for (const std::string& object : atom.objects) objects.push_back(object);
  return fmt::vformat(
      literal.value ? found->second.when_true : found->second.when_false,
      objects);
}

std::string Explain(const Excuse& excuse, const GroundTask& task,
                    const Words& words) {
  std::string text;
  for (const RequiredChange& change : excuse.changes) {
    text += (text.empty() ? "" : "\n") + Explain(change, task, words);
  }
  return text;
}

}  // namespace cell::planning
