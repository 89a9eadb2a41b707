#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/ppddl/problem.h"

namespace cell::planning {

/// The objects of a problem with its domain's constants, and its atoms that no
/// action changes.
class PpddlWorld {
 public:
  /// @param has_statics  false: as if actions could change every predicate
  PpddlWorld(const ppddl::Domain& domain, const ppddl::Problem& problem,
             bool has_statics);

  const ppddl::Domain& domain() const { return domain_; }
  const std::string& NameOf(int object) const {
    return objects_[static_cast<size_t>(object)].name;
  }
  bool IsOf(int object, int type) const {
    return domain_.IsA(objects_[static_cast<size_t>(object)].type, type);
  }
  /// Ascending.
  const std::vector<int>& ObjectsOf(int type) const {
    return objects_of_type_[static_cast<size_t>(type)];
  }
  bool IsStatic(int predicate) const {
    return is_static_[static_cast<size_t>(predicate)];
  }
  bool HoldsAtFirst(const ppddl::GroundAtom& atom) const {
    return init_.contains(atom);
  }
  /// Objects that make a static atom true at the place of an argument, given
  /// the other arguments in their order.
  const std::vector<int>& Completions(int predicate, size_t place,
                                      const std::vector<int>& others) const;

 private:
  using Completing = std::map<std::vector<int>, std::vector<int>>;

  const ppddl::Domain& domain_;
  std::vector<ppddl::Object> objects_;
  std::vector<std::vector<int>> objects_of_type_;
  std::vector<bool> is_static_;
  std::set<ppddl::GroundAtom> init_;
  mutable std::map<std::pair<int, size_t>, Completing> completions_;
};

/// Objects for the variables of a scope.
using Objects = std::vector<int>;

/// Calls visit() with all objects for the parameters that fit their types and
/// the static and the equality literals of the precondition's conjunction.
/// Returns false if it gave up after trying `max_steps` objects.
bool ForEachBinding(const PpddlWorld& world, const ppddl::Action& action,
                    int64_t max_steps,
                    const std::function<void(const Objects&)>& visit);

/// The object that a term stands for.
inline int ObjectOf(const ppddl::Term& term, const Objects& binding) {
  return term.is_variable ? binding[static_cast<size_t>(term.index)]
                          : term.index;
}

/// Calls visit() with `binding` extended by all objects for the variables.
void ForEachExtension(const PpddlWorld& world,
                      const std::vector<ppddl::Variable>& variables,
                      Objects binding,
                      const std::function<void(const Objects&)>& visit);

}  // namespace cell::planning
