#include "common/planning/ground_rules.h"

#include <functional>
#include <span>
#include <utility>

#include "common/planning/alternatives.h"

namespace cell::planning {
namespace {

using cell::Binding;

/// A rule that may cover a state, and when it does.
struct Instance {
  size_t rule;
  Binding binding;
  Alternatives when;
};

class RuleGrounder {
 public:
  RuleGrounder(const RuleSet& rules, Agent agent, const State& state)
      : rules_(rules),
        vocabulary_(rules.vocabulary()),
        agent_(agent),
        nothing_(vocabulary_.num_atoms()) {
    for (int atom = 0; atom < vocabulary_.num_atoms(); ++atom) {
      const cell::GroundAtom ground = vocabulary_.Atom(atom);
      GroundAtom named{
          vocabulary_.predicates()[static_cast<size_t>(ground.predicate)].name,
          {}};
      for (const int object : ground.objects) {
        named.objects.push_back(
            vocabulary_.objects()[static_cast<size_t>(object)].name);
      }
      result_.task.atoms.push_back(std::move(named));
    }
    result_.task.initial = AtomsOf(state);
  }

  RuleTask Ground(const Goal& goal) {
    for (const cell::GroundAction& action : rules_.GroundActions(agent_)) {
      AddAction(action);
    }
    result_.task.goals = All(goal.literals, {});
    return std::move(result_);
  }

 private:
  /// When the literal has the value.
  Alternatives When(const cell::Literal& literal, const Binding& binding,
                    bool value) const {
    if (literal.is_static) {
      return MayHold(literal, binding, nothing_, vocabulary_) == value
                 ? True()
                 : False();
    }
    const bool needs_true = literal.is_negated != value;
    Alternatives when = needs_true ? False() : True();
    for (const int atom : Groundings(literal, binding, vocabulary_)) {
      const Alternatives one = {Conjunction{{{atom, needs_true}}, {}}};
      if (!needs_true) {
        when = Both(when, one);
      } else {
        when = when.empty() ? one : Either(std::move(when), one);
      }
    }
    return when;
  }

  Alternatives All(std::span<const cell::Literal> literals,
                   const Binding& binding) const {
    Alternatives when = True();
    for (const cell::Literal& literal : literals) {
      if (when.empty()) break;
      when = Both(when, When(literal, binding, true));
    }
    return when;
  }

  /// When not all of the literals hold.
  Alternatives NotAll(std::span<const cell::Literal> literals,
                      const Binding& binding) const {
    Alternatives when;
    for (const cell::Literal& literal : literals) {
      const Alternatives one = When(literal, binding, false);
      if (one == True()) return True();
      when = when.empty() ? one : Either(std::move(when), one);
    }
    return when;
  }

  /// Binds the references from `next` on in all ways.
  void BindReferences(
      const NdrRule& rule, size_t next, const Binding& binding,
      const Alternatives& when,
      const std::function<void(const Binding&, const Alternatives&)>& visit) {
    if (when.empty()) return;
    if (next == rule.references.size()) return visit(binding, when);
    const DeicticReference& reference = rule.references[next];
    const auto& objects = vocabulary_.ObjectsOf(reference.variable.type);
    for (const int object : objects) {
      Binding bound = binding;
      bound.push_back(object);
      Alternatives unique = Both(when, All(reference.literals, bound));
      for (const int other : objects) {
        if (other == object || unique.empty()) continue;
        bound.back() = other;
        unique = Both(unique, NotAll(reference.literals, bound));
      }
      bound.back() = object;
      BindReferences(rule, next + 1, bound, unique, visit);
    }
  }

  std::vector<Instance> InstancesOf(const cell::GroundAction& action) {
    std::vector<Instance> instances;
    const Action& lifted = rules_.ActionOf(action);
    for (size_t r = 0; r < lifted.rules.size(); ++r) {
      const NdrRule& rule = lifted.rules[r];
      if (!rule.IsFor(agent_)) continue;
      BindReferences(rule, 0, action.arguments, True(),
                     [&](const Binding& binding, const Alternatives& when) {
                       Alternatives all =
                           Both(when, All(rule.context, binding));
                       if (all.empty()) return;
                       instances.push_back({r, binding, std::move(all)});
                     });
    }
    return instances;
  }

  void AddAction(const cell::GroundAction& action) {
    const std::vector<Instance> instances = InstancesOf(action);
    for (const Instance& instance : instances) {
      Alternatives when = instance.when;
      for (const Instance& other : instances) {
        // Unique references keep a rule's own instances apart.
        if (other.rule == instance.rule) continue;
        when = Both(when, Neither(other.when));
      }
      const NdrRule& rule = rules_.ActionOf(action).rules[instance.rule];
      for (const Conjunction& precondition : when) {
        result_.task.actions.push_back({rules_.Show(action), precondition,
                                        OutcomesOf(rule, instance.binding)});
        result_.action_of.push_back(action);
      }
    }
  }

  std::vector<Outcome> OutcomesOf(const NdrRule& rule,
                                  const Binding& binding) const {
    std::vector<Outcome> outcomes;
    for (const cell::Outcome& outcome : rule.outcomes) {
      Outcome ground{outcome.probability, {}};
      ForEachEffect(
          outcome, binding, vocabulary_,
          [&](const cell::Effect& effect, const Binding& bound) {
            std::vector<Literal> then;
            for (const cell::Literal& literal : effect.then) {
              for (const int atom : Groundings(literal, bound, vocabulary_)) {
                then.push_back({atom, !literal.is_negated});
              }
            }
            if (then.empty()) return;
            for (const Conjunction& when : All(effect.where, bound)) {
              ground.effects.push_back({when, then});
            }
          });
      outcomes.push_back(std::move(ground));
    }
    return outcomes;
  }

  const RuleSet& rules_;
  const Vocabulary& vocabulary_;
  Agent agent_;
  State nothing_;  // in which no atom holds, for static literals
  RuleTask result_;
};

}  // namespace

RuleTask GroundRules(const RuleSet& rules, const Goal& goal, Agent agent,
                     const State& state) {
  return RuleGrounder(rules, agent, state).Ground(goal);
}

std::vector<bool> AtomsOf(const State& state) {
  std::vector<bool> atoms;
  for (int atom = 0; atom < state.num_atoms(); ++atom) {
    atoms.push_back(state.Get(atom) == Truth::kTrue);
  }
  return atoms;
}

}  // namespace cell::planning
