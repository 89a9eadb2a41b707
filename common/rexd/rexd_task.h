#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/rules/rule.h"

namespace cell::rexd {

/// A world that a learner acts in: what its actions do, where it begins, and
/// what it should reach.
struct RexdTask {
  std::shared_ptr<const rules::World> world;
  rules::NdrRules truth;
  rules::WorldState initial;
  std::vector<rules::Literal> goal;  ///< ground; all at once

  bool IsGoal(const rules::WorldState& state) const;
};

/// Reads a task: the symbols and rules as ParseRules() does; before them lines
/// that begin with "objects:", "start:" and "goal:".
///
///   objects: a b
///   start: block(a) block(b) on(a b)
///   goal: on(b a)
///   on 2 primitive
///   ...
///   Action: put(X, Y)
///   ...
///
/// Simplification: effects for each object ("each P: ...") are refused.
/// @throws RuleError "file:line: ..."
RexdTask ParseRexdTask(const std::string& text, const std::string& file);

/// A task that differs from another one of the same world, and can be learned
/// after it. Lines of the text, each of which may be missing:
///
///   changes: broken(b) -on(a b)    what is otherwise at the start
///   goal: on(b a)                  in place of the other task's
///
/// @throws RuleError "file:line: ..."
RexdTask ParseChangedTask(const RexdTask& task, const std::string& text,
                          const std::string& file);

/// The task when its learner is not told of a predicate: it stands in no state.
/// @throws RuleError if there is no such predicate, or if a rule or the goal
/// speaks of it
RexdTask WithoutPredicate(const RexdTask& task, const std::string& predicate);

/// The task when actions may be tried with any objects. What the actions'
/// conditions ask for becomes part of the rules that are true.
RexdTask WithoutTypes(const RexdTask& task);

/// The rules when every outcome that changes something happens with
/// `success` times its probability, and otherwise nothing.
rules::NdrRules WithSuccess(const rules::NdrRules& truth, double success);

}  // namespace cell::rexd
