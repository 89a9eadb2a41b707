#include "common/rexd/rule_task.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <span>
#include <utility>

#include "common/planning/alternatives.h"

namespace cell::rexd {

using namespace rules;
using planning::Alternatives;
namespace {

constexpr size_t kMaxAlternatives = 256;

struct TooHard {
  std::string text;
};

class RuleTaskGrounder {
 public:
  RuleTaskGrounder(const NdrRules& rules, const RexdTask& task,
                   const WorldState& state)
      : rules_(rules), task_(task), world_(*task.world), state_(state) {}

  RuleTask Ground(const std::vector<GroundAct>& acts) {
    result_.task.goals = All(task_.goal, {});
    for (const GroundAct& act : acts) AddAct(act);
    return std::move(result_);
  }

 private:
  struct Instance {
    const Rule* rule;
    std::vector<int> binding;
    Alternatives when;
  };
  using Visit = std::function<void(const std::vector<int>&, Alternatives)>;

  int AtomOf(int symbol, std::span<const int> objects) {
    const int place = world_.PlaceOf(symbol, objects);
    const auto [it, is_new] =
        atom_at_.emplace(place, static_cast<int>(result_.task.atoms.size()));
    if (!is_new) return it->second;
    planning::GroundAtom atom{world_.symbols()[symbol].name, {}};
    Literal literal{symbol, {}, Comparison::kTrue, 0};
    for (const int object : objects) {
      atom.objects.push_back(world_.objects()[static_cast<size_t>(object)]);
      literal.terms.push_back({Term::Kind::kObject, object});
    }
    result_.task.atoms.push_back(std::move(atom));
    result_.task.initial.push_back(World::Get(state_, place));
    result_.atoms.push_back(std::move(literal));
    return it->second;
  }

  void Check(const Alternatives& alternatives) const {
    if (alternatives.size() > kMaxAlternatives) {
      throw TooHard{"the conditions of " + where_ + " are too many"};
    }
  }

  /// When the ground atom is true.
  Alternatives WhenTrue(int symbol, const std::vector<int>& objects) {
    const Symbol& s = world_.symbols()[symbol];
    if (s.is_primitive_predicate()) {
      return {planning::Conjunction{{{AtomOf(symbol, objects), true}}, {}}};
    }
    if (s.kind != Symbol::Kind::kConjunction) {
      throw TooHard{fmt::format(
          "'{}' is no predicate that rules change, nor a conjunction of such",
          s.name)};
    }
    std::vector<int> binding = objects;
    return WhenDefined(s.definition, &binding);
  }

  /// Over all objects for the quantified variables that are not bound yet.
  Alternatives WhenDefined(const Definition& definition,
                           std::vector<int>* binding) {
    if (binding->size() == definition.variables.size()) {
      Alternatives when = planning::True();
      for (const Definition::Atom& atom : definition.atoms) {
        std::vector<int> objects;
        for (const int v : atom.variables) {
          objects.push_back((*binding)[static_cast<size_t>(v)]);
        }
        const Alternatives one = WhenTrue(atom.symbol, objects);
        when = Both(when, atom.is_negated ? Neither(one) : one);
      }
      return when;
    }
    Alternatives joint =
        definition.is_for_all ? planning::True() : planning::False();
    for (int object = 0; object < world_.num_objects(); ++object) {
      binding->push_back(object);
      const Alternatives one = WhenDefined(definition, binding);
      joint = definition.is_for_all ? Both(joint, one) : Or(joint, one);
      binding->pop_back();
      Check(joint);
    }
    return joint;
  }

  static Alternatives Or(const Alternatives& a, const Alternatives& b) {
    if (a.empty()) return b;
    return b.empty() ? a : Either(a, b);
  }

  Alternatives When(const Literal& literal, const std::vector<int>& binding) {
    if (literal.symbol == Literal::kSame) {
      return Holds(literal, binding, state_, world_) ? planning::True()
                                                     : planning::False();
    }
    Alternatives some = planning::False();
    std::vector<int> objects;
    AddGroundings(literal, binding, &objects, &some);
    if (literal.comparison == Comparison::kTrue) return some;
    if (literal.comparison == Comparison::kFalse) return Neither(some);
    throw TooHard{fmt::format("'{}' is a function",
                              world_.symbols()[literal.symbol].name)};
  }

  void AddGroundings(const Literal& literal, const std::vector<int>& binding,
                     std::vector<int>* objects, Alternatives* some) {
    if (objects->size() == literal.terms.size()) {
      *some = Or(*some, WhenTrue(literal.symbol, *objects));
      Check(*some);
      return;
    }
    const Term& term = literal.terms[objects->size()];
    for (int object = 0; object < world_.num_objects(); ++object) {
      const bool is_other =
          (term.kind == Term::Kind::kObject && term.index != object) ||
          (term.kind == Term::Kind::kVariable &&
           binding[static_cast<size_t>(term.index)] != object);
      if (is_other) continue;
      objects->push_back(object);
      AddGroundings(literal, binding, objects, some);
      objects->pop_back();
    }
  }

  Alternatives All(const std::vector<Literal>& literals,
                   const std::vector<int>& binding) {
    Alternatives when = planning::True();
    for (const Literal& literal : literals) {
      if (when.empty()) break;
      when = Both(when, When(literal, binding));
      Check(when);
    }
    return when;
  }

  /// Binds the references from `next` on in all ways.
  void BindReferences(const Rule& rule, size_t next,
                      const std::vector<int>& binding, const Alternatives& when,
                      const Visit& visit) {
    if (when.empty()) return;
    if (next == rule.references.size()) return visit(binding, when);
    const std::vector<Literal>& literals = rule.references[next].literals;
    for (int object = 0; object < world_.num_objects(); ++object) {
      std::vector<int> bound = binding;
      bound.push_back(object);
      Alternatives unique = Both(when, All(literals, bound));
      for (int other = 0; other < world_.num_objects(); ++other) {
        if (other == object || unique.empty()) continue;
        bound.back() = other;
        unique = Both(unique, Neither(All(literals, bound)));
        Check(unique);
      }
      bound.back() = object;
      BindReferences(rule, next + 1, bound, unique, visit);
    }
  }

  void AddAct(const GroundAct& act) {
    where_ = world_.Show(act.action, act.arguments);
    std::vector<Instance> instances;
    for (const Rule& rule : rules_.rules) {
      if (rule.action != act.action) continue;
      BindReferences(rule, 0, act.arguments, planning::True(),
                     [&](const std::vector<int>& binding, Alternatives when) {
                       when = Both(when, All(rule.context, binding));
                       if (when.empty()) return;
                       instances.push_back({&rule, binding, std::move(when)});
                     });
    }
    for (const Instance& instance : instances) {
      Alternatives when = instance.when;
      for (const Instance& other : instances) {
        // Unique references keep a rule's own instances apart.
        if (other.rule != instance.rule) when = Both(when, Neither(other.when));
        Check(when);
      }
      const auto outcomes = OutcomesOf(*instance.rule, instance.binding);
      for (const planning::Conjunction& precondition : when) {
        result_.task.actions.push_back({where_, precondition, outcomes});
        result_.act_of.push_back(act);
      }
    }
  }

  std::vector<planning::Outcome> OutcomesOf(const Rule& rule,
                                            const std::vector<int>& binding) {
    std::vector<planning::Outcome> outcomes;
    for (const Outcome& outcome : rule.outcomes) {
      if (outcome.probability <= 0 || outcome.changes.empty()) continue;
      planning::ConditionalEffect effect;
      for (const Literal& change : outcome.changes) {
        if (world_.symbols()[change.symbol].is_integer) {
          throw TooHard{fmt::format("'{}' is a function",
                                    world_.symbols()[change.symbol].name)};
        }
        std::vector<int> objects;
        for (const Term& term : change.terms) {
          objects.push_back(term.kind == Term::Kind::kObject
                                ? term.index
                                : binding[static_cast<size_t>(term.index)]);
        }
        effect.then.push_back({AtomOf(change.symbol, objects),
                               change.comparison == Comparison::kTrue});
      }
      outcomes.push_back({outcome.probability, {std::move(effect)}});
    }
    return outcomes;
  }

  const NdrRules& rules_;
  const RexdTask& task_;
  const World& world_;
  const WorldState& state_;
  std::string where_ = "the goal";
  std::map<int, int> atom_at_;  // by place
  RuleTask result_;
};

}  // namespace

Result<RuleTask> GroundRuleTask(const NdrRules& rules, const RexdTask& task,
                                const WorldState& state,
                                const std::vector<GroundAct>& acts) {
  try {
    return RuleTaskGrounder(rules, task, state).Ground(acts);
  } catch (const TooHard& hard) {
    return Reason{hard.text};
  }
}

}  // namespace cell::rexd
