#include "common/planning/excuse.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <utility>

#include "common/planning/causal_graph.h"
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
        graph_(task),
        goal_search_(model_) {}

  Excuses Find() {
    Excuses result;
    result.is_solvable = Helps({});
    result.is_minimal = true;
    if (!result.is_solvable) {
      FindSmallest();
      result.is_minimal = found_.empty() ? !was_cut_ : is_sure_;
    }
    Rank();
    for (const Changes& changes : found_) {
      result.excuses.push_back(ExcuseOf(changes));
    }
    result.num_trials = num_trials_;
    return result;
  }

 private:
  /// Predicates of facts that are given: some hold, and no action makes any
  /// true.
  void FindGiven() {
    for (size_t atom = 0; atom < task_.atoms.size(); ++atom) {
      if (task_.initial[atom]) given_.insert(task_.atoms[atom].predicate);
    }
    for (size_t atom = 0; atom < task_.atoms.size(); ++atom) {
      const Literal literal{static_cast<int>(atom), true};
      if (!graph_.ProducersOf(literal).empty()) {
        given_.erase(task_.atoms[atom].predicate);
      }
    }
  }

  const std::string& PredicateOf(const Literal& literal) const {
    return task_.atoms[static_cast<size_t>(literal.atom)].predicate;
  }

  bool IsGiven(const Literal& literal) const {
    return literal.value && given_.contains(PredicateOf(literal));
  }

  /// The best excuses first, as many as are asked for.
  void Rank() {
    FindGiven();
    const auto cost = [this](const Changes& changes) {
      std::array<int, 3> doubts{};
      for (const Literal& l : changes) {
        doubts[0] += graph_.IsOfGoal(l);
        doubts[1] += IsGiven(l);
        doubts[2] += !graph_.ProducersOf(l).empty();
      }
      return doubts;
    };
    std::ranges::stable_sort(found_, {}, cost);
    // Those that speak of what no better one speaks of, before the others.
    std::set<std::vector<std::string>> seen;
    std::vector<Changes> others;
    std::erase_if(found_, [&](const Changes& changes) {  // in their order
      std::vector<std::string> predicates;
      for (const Literal& l : changes) predicates.push_back(PredicateOf(l));
      std::ranges::sort(predicates);
      const bool is_new = seen.insert(predicates).second;
      if (!is_new) others.push_back(changes);
      return !is_new;
    });
    found_.insert(found_.end(), others.begin(), others.end());
    const auto most = static_cast<size_t>(options_.max_excuses);
    if (found_.size() > most) found_.resize(most);
  }

  /// Tries all sets of 1, 2, ... changes until some help.
  void FindSmallest() {
    for (int size = 1; size <= options_.max_changes; ++size) {
      is_sure_ = !was_cut_;
      tried_.clear();
      Extend({}, size);
      if (!found_.empty() || num_trials_ == options_.max_trials) return;
    }
  }

  /// Adds the sets that help, of `size` changes, that hold these.
  void Extend(const Changes& changes, int size) {
    if (IsOver()) return;
    const int num_open = size - static_cast<int>(changes.size());
    const Regression reached(graph_, changes);
    const bool has_goal = reached.HasGoal();
    if (num_open == 0) {
      if (has_goal && Helps(changes)) found_.push_back(changes);
      return;
    }
    const auto may_add = [&](const Literal& l) {
      return task_.initial[static_cast<size_t>(l.atom)] != l.value &&
             std::ranges::find(changes, l) == changes.end() &&
             (!options_.may_change || options_.may_change(l));
    };
    // Beyond the relaxation any change might help.
    const Regression::Gap gap =
        has_goal ? Regression::Gap{AllChanges(), 1} : reached.FindGap(may_add);
    if (gap.least_changes > num_open) return;
    for (const Literal& l : gap.literals) {
      if (!may_add(l)) continue;
      Changes more = changes;
      more.insert(std::ranges::upper_bound(more, l), l);
      if (tried_.insert(more).second) Extend(more, size);
    }
  }

  bool IsOver() {
    if (num_trials_ == options_.max_trials) {
      was_cut_ = true;
      return true;
    }
    ++num_trials_;
    return false;
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

  Excuse ExcuseOf(const Changes& changes) const {
    const Regression before(graph_, {});
    const Regression after(graph_, changes);
    Excuse excuse;
    for (const Literal& l : changes) {
      RequiredChange change{
          l, {}, !graph_.ProducersOf(l).empty(), graph_.IsOfGoal(l)};
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
  CausalGraph graph_;
  GoalSearch goal_search_;
  bool was_cut_ = false;
  bool is_sure_ = true;  // that nothing smaller than what is found helps
  int64_t num_trials_ = 0;
  std::set<std::string> given_;
  std::set<Changes> tried_;
  std::vector<Changes> found_;
};

/// What needs the change: an action, or the goal itself.
std::string NeederOf(const RequiredChange& change) {
  if (change.is_of_goal) return "the goal";
  return change.needed_by.empty() ? "" : change.needed_by.front();
}

std::string Explain(const RequiredChange& change, const GroundTask& task,
                    const Words& words) {
  const Literal opposite{change.literal.atom, !change.literal.value};
  std::string text = NeederOf(change);
  if (!text.empty()) {
    text += " needs: " + Say(change.literal, task, words) + "; but ";
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
