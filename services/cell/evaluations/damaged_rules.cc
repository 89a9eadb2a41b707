#include "services/cell/evaluations/damaged_rules.h"

#include <algorithm>
#include <utility>

#include "common/planning/planner.h"
#include "common/rexd/guidance.h"
#include "common/rexd/rule_model.h"
#include "common/rexd/rule_task.h"
#include "common/rules/rule_text.h"
#include "common/rules/simulation.h"

namespace cell::cli {

/// The rules, and what was done to them.
struct DamagedRules::Damaged {
  rules::NdrRules rules;
  Damage damage = Damage::kRule;
  std::string what;
  std::set<std::string> missing;
};

namespace {

std::string NameOf(const rules::Rule& rule, const rules::SymbolTable& symbols) {
  std::string text = symbols[rule.action].name + "(";
  for (size_t i = 0; i < rule.arguments.size(); ++i) {
    text += (i == 0 ? "" : ", ") + rule.arguments[i];
  }
  return text + ")";
}

bool Contradicts(const rules::Literal& literal,
                 const std::vector<rules::Literal>& context) {
  return std::ranges::any_of(context, [&](const rules::Literal& other) {
    return other.symbol == literal.symbol && other.terms == literal.terms;
  });
}

/// A predicate of the rule's variables, of `_` and of constants, or its
/// negation.
rules::Literal DrawLiteral(const rules::Rule& rule, const rules::World& world,
                           rules::RandomNumbers* random) {
  std::vector<int> predicates;
  for (size_t i = 0; i < world.symbols().all().size(); ++i) {
    if (!world.symbols().all()[i].is_primitive_predicate()) continue;
    predicates.push_back(static_cast<int>(i));
  }
  rules::Literal literal{
      OneOf(predicates, random), {}, rules::Comparison::kTrue, 0};
  std::vector<rules::Term> terms = {{rules::Term::Kind::kAny, 0}};
  for (int i = 0; i < rule.num_variables(); ++i) {
    terms.push_back({rules::Term::Kind::kVariable, i});
    terms.push_back({rules::Term::Kind::kVariable, i});  // twice as often
  }
  for (int i = 0; i < world.num_constants(); ++i) {
    terms.push_back({rules::Term::Kind::kObject, i});
  }
  for (int i = 0; i < world.symbols()[literal.symbol].arity; ++i) {
    literal.terms.push_back(OneOf(terms, random));
  }
  if (random->Below(2) == 0) literal.comparison = rules::Comparison::kFalse;
  return literal;
}

/// The state with the changes of atoms of the task.
rules::WorldState With(const planning::Changes& changes,
                       const rexd::RuleTask& ground, const rules::World& world,
                       rules::WorldState state) {
  for (const planning::Literal& change : changes) {
    const rules::Literal& atom = ground.atoms[static_cast<size_t>(change.atom)];
    std::vector<int> objects;
    for (const rules::Term& term : atom.terms) objects.push_back(term.index);
    rules::World::Set(&state, world.PlaceOf(atom.symbol, objects),
                      change.value);
  }
  world.Derive(&state);
  return state;
}

bool HasPlan(const rules::NdrRules& rules, rexd::RexdTask task,
             const std::vector<rules::GroundAct>& acts,
             const rules::WorldState& state) {
  task.initial = state;
  const auto model = std::make_shared<rexd::RuleModel>(rules, task, acts);
  planning::Planner::Params params;
  params.minimize_actions = false;
  const auto status =
      planning::Planner(model, params).Find(model->Pack(state)).status;
  return status == planning::Plan::Status::kFound ||
         status == planning::Plan::Status::kGoalReached;
}

/// The literals of the learner's excuse as changes of the task.
planning::Changes ChangesOf(const std::vector<rules::Literal>& excuse,
                            const rexd::RuleTask& ground) {
  planning::Changes changes;
  for (rules::Literal literal : excuse) {
    const bool value = literal.comparison == rules::Comparison::kTrue;
    literal.comparison = rules::Comparison::kTrue;
    const auto it = std::ranges::find(ground.atoms, literal);
    changes.push_back({static_cast<int>(it - ground.atoms.begin()), value});
  }
  std::ranges::sort(changes);
  return changes;
}

}  // namespace

DamagedRules::DamagedRules(rexd::RexdTask task)
    : task_(std::move(task)),
      acts_(rules::GroundActs(*task_.world, task_.initial)) {}

std::optional<DamagedRules::Damaged> DamagedRules::DamageRules(
    rules::RandomNumbers* random) const {
  const rules::SymbolTable& symbols = task_.world->symbols();
  Damaged damaged{task_.truth, static_cast<Damage>(random->Below(3)), "", {}};
  const int index = random->Below(static_cast<int>(damaged.rules.rules.size()));
  rules::Rule& rule = damaged.rules.rules[static_cast<size_t>(index)];
  damaged.what = NameOf(rule, symbols);
  if (damaged.damage == Damage::kRule) {
    for (const rules::Outcome& outcome : rule.outcomes) {
      for (const rules::Literal& change : outcome.changes) {
        damaged.missing.insert(symbols[change.symbol].name);
      }
    }
    damaged.rules.rules.erase(damaged.rules.rules.begin() + index);
    return damaged;
  }
  if (damaged.damage == Damage::kEffect) {
    const int place = random->Below(static_cast<int>(rule.outcomes.size()));
    auto& changes = rule.outcomes[static_cast<size_t>(place)].changes;
    if (changes.empty()) return std::nullopt;
    const int at = random->Below(static_cast<int>(changes.size()));
    const rules::Literal change = changes[static_cast<size_t>(at)];
    damaged.what += " without " + rules::ToText(change, rule, symbols);
    damaged.missing = {symbols[change.symbol].name};
    changes.erase(changes.begin() + at);
    return damaged;
  }
  const rules::Literal literal = DrawLiteral(rule, *task_.world, random);
  if (Contradicts(literal, rule.context)) return std::nullopt;
  damaged.what += " needs " + rules::ToText(literal, rule, symbols);
  damaged.missing = {symbols[literal.symbol].name};
  rule.context.push_back(literal);
  return damaged;
}

rules::WorldState DamagedRules::DrawState(rules::RandomNumbers* random) const {
  rules::WorldState state = task_.initial;
  for (int left = random->Below(kMaxWalk); left > 0; --left) {
    std::vector<rules::GroundAct> possible;
    for (const rules::GroundAct& act : acts_) {
      if (rules::FindCoverage(task_.truth, act, state, *task_.world)) {
        possible.push_back(act);
      }
    }
    if (possible.empty()) break;
    state = rules::Simulate(task_.truth, *task_.world, OneOf(possible, random),
                            state, random);
  }
  return state;
}

std::optional<ExcuseCase> DamagedRules::Draw(uint64_t seed) const {
  rules::RandomNumbers random(seed);
  const auto damaged = DamageRules(&random);
  const rules::WorldState state = DrawState(&random);
  if (!damaged) return std::nullopt;
  const bool is_lost = HasPlan(task_.truth, task_, acts_, state) &&
                       !HasPlan(damaged->rules, task_, acts_, state);
  const auto ground = rexd::GroundRuleTask(damaged->rules, task_, state, acts_);
  if (!is_lost || !ground) return std::nullopt;
  const rexd::Guidance guidance =
      rexd::FindGuidance(damaged->rules, task_, state, acts_);
  ExcuseCase result{damaged->damage,
                    damaged->what,
                    damaged->missing,
                    ground->task,
                    {},
                    rexd::ToText(guidance, *task_.world),
                    !guidance.excuses.empty()};
  for (const auto& excuse : guidance.excuses) {
    result.excuses.push_back(ChangesOf(excuse, *ground));
    result.helps &=
        HasPlan(damaged->rules, task_, acts_,
                With(result.excuses.back(), *ground, *task_.world, state));
  }
  return result;
}

}  // namespace cell::cli
