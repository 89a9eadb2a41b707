#include "common/planning/ppddl_conditions.h"

#include <fmt/format.h>

#include <utility>

namespace cell::planning {
namespace {

using ppddl::Condition;

constexpr int64_t kMaxInstances = 1'000'000;

}  // namespace

void PpddlConditions::CheckSize(const Alternatives& alternatives) const {
  if (static_cast<int>(alternatives.size()) > limits_.max_alternatives) {
    throw TooLarge{
        fmt::format("a condition of {} has more than {} alternatives; split it",
                    where_, limits_.max_alternatives)};
  }
}

void PpddlConditions::Begin(const std::string& where) {
  where_ = where;
  num_instances_ = 0;
}

void PpddlConditions::CountInstances(
    const std::vector<ppddl::Variable>& variables) {
  double product = 1;
  for (const ppddl::Variable& variable : variables) {
    product *= static_cast<double>(world_.ObjectsOf(variable.type).size());
  }
  // Those of nested quantifiers add up.
  num_instances_ += product;
  if (num_instances_ > kMaxInstances) {
    throw TooLarge{
        fmt::format("quantifiers of {} have more than {} instances; "
                    "{}",
                    where_, kMaxInstances, kNarrower)};
  }
}

std::optional<int> PpddlConditions::AtomOf(
    int predicate, const std::vector<ppddl::Term>& terms,
    const Objects& binding) {
  ppddl::GroundAtom atom{predicate, {}};
  const auto& parameters =
      world_.domain().predicates[static_cast<size_t>(predicate)].parameters;
  for (size_t i = 0; i < terms.size(); ++i) {
    atom.objects.push_back(ObjectOf(terms[i], binding));
    if (!world_.IsOf(atom.objects.back(), parameters[i].type)) {
      return std::nullopt;
    }
  }
  return Intern(atom);
}

int PpddlConditions::Intern(const ppddl::GroundAtom& atom) {
  const auto [it, is_new] =
      index_of_.try_emplace(atom, static_cast<int>(atoms_.size()));
  if (is_new) {
    const auto& predicates = world_.domain().predicates;
    GroundAtom shown{predicates[static_cast<size_t>(atom.predicate)].name, {}};
    for (const int object : atom.objects) {
      shown.objects.push_back(world_.NameOf(object));
    }
    atoms_.push_back(std::move(shown));
    initial_.push_back(world_.HoldsAtFirst(atom));
  }
  return it->second;
}

Alternatives PpddlConditions::NormalizeAtom(const Condition& condition,
                                            bool value,
                                            const Objects& binding) {
  if (world_.IsStatic(condition.predicate)) {
    ppddl::GroundAtom atom{condition.predicate, {}};
    for (const ppddl::Term& term : condition.terms) {
      atom.objects.push_back(ObjectOf(term, binding));
    }
    return world_.HoldsAtFirst(atom) == value ? True() : False();
  }
  const std::optional<int> atom =
      AtomOf(condition.predicate, condition.terms, binding);
  if (!atom) return value ? False() : True();
  return {Conjunction{{{*atom, value}}, {}}};
}

Alternatives PpddlConditions::Normalize(const Condition& condition, bool value,
                                        const Objects& binding) {
  using enum Condition::Kind;
  switch (condition.kind) {
    case kAtom:
      return NormalizeAtom(condition, value, binding);
    case kEqual:
      return (ObjectOf(condition.terms[0], binding) ==
              ObjectOf(condition.terms[1], binding)) == value
                 ? True()
                 : False();
    case kNot:
      return Normalize(condition.parts[0], !value, binding);
    case kImply:
      return Join(value == false,
                  {Normalize(condition.parts[0], !value, binding),
                   Normalize(condition.parts[1], value, binding)});
    case kAnd:
    case kOr:
      return Join((condition.kind == kAnd) == value,
                  PartsOf(condition, value, binding));
    case kForall:
    case kExists:
      return Join((condition.kind == kForall) == value,
                  InstancesOf(condition, value, binding));
  }
  return {};
}

std::vector<Alternatives> PpddlConditions::PartsOf(const Condition& condition,
                                                   bool value,
                                                   const Objects& binding) {
  std::vector<Alternatives> parts;
  for (const Condition& part : condition.parts) {
    parts.push_back(Normalize(part, value, binding));
  }
  return parts;
}

std::vector<Alternatives> PpddlConditions::InstancesOf(
    const Condition& condition, bool value, const Objects& binding) {
  CountInstances(condition.variables);
  std::vector<Alternatives> instances;
  ForEachExtension(
      world_, condition.variables, binding, [&](const Objects& extended) {
        instances.push_back(Normalize(condition.parts[0], value, extended));
      });
  return instances;
}

Alternatives PpddlConditions::Join(
    bool all, const std::vector<Alternatives>& parts) const {
  Alternatives joint = all ? True() : False();
  for (const Alternatives& part : parts) {
    if (!all && part == True()) return True();
    if (all) {
      joint = Both(joint, part);
    } else {
      joint = joint.empty() ? part : Either(std::move(joint), part);
    }
    CheckSize(joint);
  }
  return joint;
}

}  // namespace cell::planning
