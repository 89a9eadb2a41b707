#include "common/planning/ppddl_bindings.h"

#include <algorithm>
#include <optional>

namespace cell::planning {
namespace {

using ppddl::Condition;
using ppddl::Term;

void MarkChanged(const ppddl::Effect& effect, std::vector<bool>* is_static) {
  if (effect.kind == ppddl::Effect::Kind::kAdd ||
      effect.kind == ppddl::Effect::Kind::kDelete) {
    (*is_static)[static_cast<size_t>(effect.symbol)] = false;
  }
  for (const ppddl::Effect& part : effect.parts) MarkChanged(part, is_static);
}

/// A literal that can be checked as soon as its last variable is bound.
struct Check {
  const Condition* literal;  // an atom or an equality
  bool value;
};

/// The number of variables that must be bound first.
size_t NumNeeded(const Condition& literal) {
  int last = -1;
  for (const Term& term : literal.terms) {
    if (term.is_variable) last = std::max(last, term.index);
  }
  return static_cast<size_t>(last + 1);
}

class Enumeration {
 public:
  Enumeration(const PpddlWorld& world, const ppddl::Action& action,
              int64_t max_steps,
              const std::function<void(const Objects&)>& visit)
      : world_(world),
        parameters_(action.parameters),
        checks_(action.parameters.size() + 1),
        num_steps_left_(max_steps),
        visit_(visit) {
    Collect(action.precondition);
  }

  bool Run() {
    if (Passes()) Extend();
    return num_steps_left_ >= 0;
  }

 private:
  void Collect(const Condition& condition) {
    if (condition.kind == Condition::Kind::kAnd) {
      for (const Condition& part : condition.parts) Collect(part);
      return;
    }
    const bool is_negated = condition.kind == Condition::Kind::kNot;
    const Condition& literal = is_negated ? condition.parts.front() : condition;
    const bool is_fixed = literal.kind == Condition::Kind::kEqual ||
                          (literal.kind == Condition::Kind::kAtom &&
                           world_.IsStatic(literal.predicate));
    if (is_fixed) {
      checks_[NumNeeded(literal)].push_back({&literal, !is_negated});
    }
  }

  bool Holds(const Condition& literal) const {
    ppddl::GroundAtom atom{literal.predicate, {}};
    for (const Term& term : literal.terms) {
      atom.objects.push_back(ObjectOf(term, binding_));
    }
    if (literal.kind == Condition::Kind::kEqual) {
      return atom.objects[0] == atom.objects[1];
    }
    return world_.HoldsAtFirst(atom);
  }

  /// The checks whose last variable was bound last.
  bool Passes() const {
    return std::ranges::all_of(checks_[binding_.size()],
                               [&](const Check& check) {
                                 return Holds(*check.literal) == check.value;
                               });
  }

  /// Objects for the next parameter from a static atom that speaks of it once.
  const std::vector<int>* Completions() const {
    const int next = static_cast<int>(binding_.size());
    for (const Check& check : checks_[binding_.size() + 1]) {
      if (!check.value || check.literal->kind != Condition::Kind::kAtom) {
        continue;
      }
      const std::vector<Term>& terms = check.literal->terms;
      const Term wanted{true, next};
      if (std::ranges::count(terms, wanted) != 1) continue;
      const auto place =
          static_cast<size_t>(std::ranges::find(terms, wanted) - terms.begin());
      std::vector<int> others;
      for (size_t i = 0; i < terms.size(); ++i) {
        if (i != place) others.push_back(ObjectOf(terms[i], binding_));
      }
      return &world_.Completions(check.literal->predicate, place, others);
    }
    return nullptr;
  }

  void Extend() {
    if (binding_.size() == parameters_.size()) {
      visit_(binding_);
      return;
    }
    const int type = parameters_[binding_.size()].type;
    const std::vector<int>* few = Completions();
    for (const int object : few ? *few : world_.ObjectsOf(type)) {
      if (!world_.IsOf(object, type)) continue;
      if (--num_steps_left_ < 0) return;
      binding_.push_back(object);
      if (Passes()) Extend();
      binding_.pop_back();
    }
  }

  const PpddlWorld& world_;
  const std::vector<ppddl::Variable>& parameters_;
  std::vector<std::vector<Check>> checks_;  // by the number of bound variables
  int64_t num_steps_left_;
  const std::function<void(const Objects&)>& visit_;
  Objects binding_;
};

}  // namespace

PpddlWorld::PpddlWorld(const ppddl::Domain& domain,
                       const ppddl::Problem& problem, bool has_statics)
    : domain_(domain),
      objects_(domain.constants),
      objects_of_type_(domain.types.size()),
      is_static_(domain.predicates.size(), has_statics),
      init_(problem.init.begin(), problem.init.end()) {
  objects_.insert(objects_.end(), problem.objects.begin(),
                  problem.objects.end());
  for (size_t type = 0; type < domain.types.size(); ++type) {
    for (size_t object = 0; object < objects_.size(); ++object) {
      if (IsOf(static_cast<int>(object), static_cast<int>(type))) {
        objects_of_type_[type].push_back(static_cast<int>(object));
      }
    }
  }
  for (const ppddl::Action& action : domain.actions) {
    MarkChanged(action.effect, &is_static_);
  }
}

const std::vector<int>& PpddlWorld::Completions(
    int predicate, size_t place, const std::vector<int>& others) const {
  static const std::vector<int> kNone;
  const auto [it, is_new] =
      completions_.try_emplace({predicate, place}, Completing{});
  Completing& completing = it->second;
  if (is_new) {
    for (const ppddl::GroundAtom& atom : init_) {
      if (atom.predicate != predicate) continue;
      std::vector<int> rest = atom.objects;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
      completing[rest].push_back(atom.objects[place]);
    }
    for (auto& [rest, objects] : completing) std::ranges::sort(objects);
  }
  const auto found = completing.find(others);
  return found == completing.end() ? kNone : found->second;
}

bool ForEachBinding(const PpddlWorld& world, const ppddl::Action& action,
                    int64_t max_steps,
                    const std::function<void(const Objects&)>& visit) {
  return Enumeration(world, action, max_steps, visit).Run();
}

void ForEachExtension(const PpddlWorld& world,
                      const std::vector<ppddl::Variable>& variables,
                      Objects binding,
                      const std::function<void(const Objects&)>& visit) {
  const size_t num_bound = binding.size();
  const std::function<void()> extend = [&] {
    const size_t next = binding.size() - num_bound;
    if (next == variables.size()) {
      visit(binding);
      return;
    }
    for (const int object : world.ObjectsOf(variables[next].type)) {
      binding.push_back(object);
      extend();
      binding.pop_back();
    }
  };
  extend();
}

}  // namespace cell::planning
