#include "services/cell/evaluations/damaged_ppddl.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "common/planning/excuse.h"
#include "common/planning/ground_model.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/planner.h"

namespace cell::cli {

/// The domain, and what was done to it.
struct DamagedPpddl::Damaged {
  ppddl::Domain domain;
  Damage damage = Damage::kRule;
  std::string what;
  std::set<std::string> missing;
};

namespace {

/// The effects that make an atom true or false.
void AddChanges(ppddl::Effect* effect, std::vector<ppddl::Effect*>* changes) {
  const bool is_change = effect->kind == ppddl::Effect::Kind::kAdd ||
                         effect->kind == ppddl::Effect::Kind::kDelete;
  if (is_change) changes->push_back(effect);
  for (ppddl::Effect& part : effect->parts) AddChanges(&part, changes);
}

/// A predicate of the action's parameters and of constants that fit, or its
/// negation; nullopt if there are none for the predicate.
std::optional<ppddl::Condition> DrawCondition(const ppddl::Action& action,
                                              const ppddl::Domain& domain,
                                              rules::RandomNumbers* random) {
  ppddl::Condition atom{ppddl::Condition::Kind::kAtom, 0, {}, {}, {}};
  atom.predicate = random->Below(static_cast<int>(domain.predicates.size()));
  const auto& predicate =
      domain.predicates[static_cast<size_t>(atom.predicate)];
  for (const ppddl::Variable& parameter : predicate.parameters) {
    std::vector<ppddl::Term> terms;
    for (size_t i = 0; i < action.parameters.size(); ++i) {
      if (domain.IsA(action.parameters[i].type, parameter.type)) {
        terms.push_back({true, static_cast<int>(i)});
      }
    }
    for (size_t i = 0; i < domain.constants.size(); ++i) {
      if (domain.IsA(domain.constants[i].type, parameter.type)) {
        terms.push_back({false, static_cast<int>(i)});
      }
    }
    if (terms.empty()) return std::nullopt;
    atom.terms.push_back(OneOf(terms, random));
  }
  if (random->Below(2) == 0) return atom;
  return ppddl::Condition{ppddl::Condition::Kind::kNot, 0, {}, {}, {atom}};
}

std::string ShowCondition(const ppddl::Condition& condition,
                          const ppddl::Action& action,
                          const ppddl::Domain& domain) {
  if (condition.kind == ppddl::Condition::Kind::kNot) {
    return "not " + ShowCondition(condition.parts[0], action, domain);
  }
  std::string text =
      domain.predicates[static_cast<size_t>(condition.predicate)].name + "(";
  for (size_t i = 0; i < condition.terms.size(); ++i) {
    const ppddl::Term& term = condition.terms[i];
    const auto index = static_cast<size_t>(term.index);
    text += (i == 0 ? "" : ", ") + (term.is_variable
                                        ? action.parameters[index].name
                                        : domain.constants[index].name);
  }
  return text + ")";
}

planning::GroundTask GroundOrThrow(const ppddl::Domain& domain,
                                   const ppddl::Problem& problem,
                                   planning::ConstantAtoms constants) {
  auto task = planning::GroundPpddl(domain, problem, constants);
  if (!task) throw std::runtime_error(problem.name + ": " + task.reason());
  return *std::move(task);
}

bool HasPpddlPlan(const ppddl::Domain& domain, const ppddl::Problem& problem) {
  const auto model = std::make_shared<planning::GroundModel>(
      GroundOrThrow(domain, problem, planning::ConstantAtoms::kReplace));
  planning::Planner::Params params;
  params.minimize_actions = false;
  const auto status =
      planning::Planner(model, params).Find(model->initial()).status;
  return status == planning::Plan::Status::kFound ||
         status == planning::Plan::Status::kGoalReached;
}

int PlaceOfObject(const std::string& object, const ppddl::Domain& domain,
                  const ppddl::Problem& problem) {
  const auto it =
      std::ranges::find(domain.constants, object, &ppddl::Object::name);
  if (it != domain.constants.end()) {
    return static_cast<int>(it - domain.constants.begin());
  }
  const auto other =
      std::ranges::find(problem.objects, object, &ppddl::Object::name);
  return static_cast<int>(domain.constants.size() +
                          static_cast<size_t>(other - problem.objects.begin()));
}

/// Makes an atom true or false at first.
void SetAtFirst(const planning::GroundAtom& atom, bool value,
                const ppddl::Domain& domain, ppddl::Problem* problem) {
  const auto it = std::ranges::find(domain.predicates, atom.predicate,
                                    &ppddl::Symbol::name);
  ppddl::GroundAtom ground{static_cast<int>(it - domain.predicates.begin()),
                           {}};
  for (const std::string& object : atom.objects) {
    ground.objects.push_back(PlaceOfObject(object, domain, *problem));
  }
  std::erase(problem->init, ground);
  if (value) problem->init.push_back(std::move(ground));
}

}  // namespace

DamagedPpddl::DamagedPpddl(ppddl::Domain domain, ppddl::Problem problem)
    : domain_(std::move(domain)),
      problem_(std::move(problem)),
      model_(std::make_shared<planning::GroundModel>(
          GroundOrThrow(domain_, problem_, planning::ConstantAtoms::kKeep))) {}

std::optional<DamagedPpddl::Damaged> DamagedPpddl::DamageDomain(
    rules::RandomNumbers* random) const {
  Damaged damaged{domain_, static_cast<Damage>(random->Below(3)), "", {}};
  const int index = random->Below(static_cast<int>(domain_.actions.size()));
  ppddl::Action& action = damaged.domain.actions[static_cast<size_t>(index)];
  damaged.what = action.name;
  std::vector<ppddl::Effect*> changes;
  AddChanges(&action.effect, &changes);
  const auto name_of = [&](int symbol) {
    return domain_.predicates[static_cast<size_t>(symbol)].name;
  };
  if (damaged.damage == Damage::kRule) {
    for (const ppddl::Effect* change : changes) {
      damaged.missing.insert(name_of(change->symbol));
    }
    damaged.domain.actions.erase(damaged.domain.actions.begin() + index);
    return damaged;
  }
  if (damaged.damage == Damage::kEffect) {
    if (changes.empty()) return std::nullopt;
    ppddl::Effect& change = *OneOf(changes, random);
    damaged.what +=
        (change.kind == ppddl::Effect::Kind::kAdd ? " without "
                                                  : " without not ") +
        name_of(change.symbol);
    damaged.missing = {name_of(change.symbol)};
    change = ppddl::Effect{};
    return damaged;
  }
  const auto condition = DrawCondition(action, domain_, random);
  if (!condition) return std::nullopt;
  const ppddl::Condition& atom = condition->kind == ppddl::Condition::Kind::kNot
                                     ? condition->parts[0]
                                     : *condition;
  damaged.what += " needs " + ShowCondition(*condition, action, domain_);
  damaged.missing = {name_of(atom.predicate)};
  action.precondition = {ppddl::Condition::Kind::kAnd,
                         0,
                         {},
                         {},
                         {action.precondition, *condition}};
  return damaged;
}

ppddl::Problem DamagedPpddl::DrawProblem(rules::RandomNumbers* random) const {
  std::vector<uint64_t> state = model_->initial();
  planning::Expansion expansion(model_->num_words());
  for (int left = random->Below(kMaxWalk); left > 0; --left) {
    if (model_->IsGoal(state)) break;
    expansion.Clear();
    model_->Expand(state, &expansion);
    if (expansion.choices().empty()) break;
    const auto& choice = expansion.choices()[static_cast<size_t>(
        random->Below(static_cast<int>(expansion.choices().size())))];
    // Unlikely outcomes are as good states to ask in.
    const planning::Bits next = expansion.state(
        choice.first_outcome + random->Below(choice.num_outcomes));
    state.assign(next.begin(), next.end());
  }
  ppddl::Problem problem = problem_;
  const planning::GroundTask& task = model_->task();
  for (size_t atom = 0; atom < task.atoms.size(); ++atom) {
    const bool value = state[atom / 64] >> (atom % 64) & 1;
    if (value == task.initial[atom]) continue;
    SetAtFirst(task.atoms[atom], value, domain_, &problem);
  }
  return problem;
}

std::optional<ExcuseCase> DamagedPpddl::Draw(uint64_t seed) const {
  rules::RandomNumbers random(seed);
  const auto damaged = DamageDomain(&random);
  const ppddl::Problem problem = DrawProblem(&random);
  const bool is_lost = damaged && HasPpddlPlan(domain_, problem) &&
                       !HasPpddlPlan(damaged->domain, problem);
  if (!is_lost) return std::nullopt;
  ExcuseCase result{
      damaged->damage,
      damaged->what,
      damaged->missing,
      GroundOrThrow(damaged->domain, problem, planning::ConstantAtoms::kKeep),
      {},
      "",
      false};
  const planning::Excuses found = FindExcuses(result.task);
  result.helps = !found.excuses.empty();
  for (const planning::Excuse& excuse : found.excuses) {
    ppddl::Problem changed = problem;
    result.excuses.emplace_back();
    for (const planning::RequiredChange& change : excuse.changes) {
      const planning::Literal& literal = change.literal;
      result.excuses.back().push_back(literal);
      SetAtFirst(result.task.atoms[static_cast<size_t>(literal.atom)],
                 literal.value, domain_, &changed);
    }
    result.helps &= HasPpddlPlan(damaged->domain, changed);
    result.text += Explain(excuse, result.task) + "\n";
  }
  return result;
}

}  // namespace cell::cli
