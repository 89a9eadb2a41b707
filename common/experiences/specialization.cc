#include "common/experiences/specialization.h"

#include <algorithm>
#include <utility>

#include "common/experiences/literal_space.h"

namespace cell {
namespace {

using rules::Comparison;
using rules::Experience;

/// One in so many is taken for sensed wrongly.
constexpr std::ptrdiff_t kSuccessesPerException = 20;

std::vector<rules::Term> TermsOf(const rules::Rule& rule,
                                 const rules::World& world) {
  std::vector<rules::Term> terms = ArgumentTerms(rule);
  for (int i = 0; i < world.num_constants(); ++i) {
    terms.push_back({rules::Term::Kind::kObject, i});
  }
  terms.push_back({rules::Term::Kind::kAny, 0});
  return terms;
}

/// True if `a` holds wherever `b` does, by its words: "not On(X, _)" says more
/// than "not On(X, a)", and "On(X, a)" more than "On(X, _)".
bool Follows(const rules::Literal& a, const rules::Literal& b) {
  if (a == b || a.symbol != b.symbol || a.comparison != b.comparison) {
    return false;
  }
  const rules::Literal& general = a.comparison == Comparison::kTrue ? a : b;
  const rules::Literal& special = a.comparison == Comparison::kTrue ? b : a;
  for (size_t i = 0; i < a.terms.size(); ++i) {
    if (general.terms[i] != special.terms[i] &&
        general.terms[i].kind != rules::Term::Kind::kAny) {
      return false;
    }
  }
  return true;
}

}  // namespace

void SeenAtoms::Add(const rules::BitSet& atoms) {
  ever |= atoms;
  always &= atoms;
}

void SeenAtoms::Add(const SeenAtoms& other) {
  ever |= other.ever;
  always &= other.always;
}

Specialization::Specialization(std::shared_ptr<const rules::World> world,
                               Params params)
    : world_(std::move(world)), params_(std::move(params)), atoms_(world_) {}

void Specialization::Apply(std::span<const Experience> experiences,
                           std::span<const std::vector<int>> bindings,
                           const SeenAtoms& seen, rules::Rule* rule) const {
  const std::vector<Success> successes = SuccessesOf(*rule, experiences);
  if (successes.empty()) return;
  std::vector<rules::Literal> shared = SharedLiterals(*rule, successes);
  std::erase_if(shared, [&](const rules::Literal& literal) {
    return !IsTelling(literal, bindings, seen);
  });
  for (const rules::Literal& literal : rule->context) {
    if (std::ranges::count(shared, literal) == 0) shared.push_back(literal);
  }
  rule->context.clear();
  for (const rules::Literal& literal : shared) {
    if (std::ranges::none_of(shared, [&](const rules::Literal& other) {
          return Follows(literal, other);
        })) {
      rule->context.push_back(literal);
    }
  }
}

std::vector<Specialization::Success> Specialization::SuccessesOf(
    const rules::Rule& rule, std::span<const Experience> experiences) const {
  std::vector<Success> successes;
  for (const Experience& e : experiences) {
    if (e.before != e.after &&
        rules::Bind(rule, e.act.arguments, e.before, *world_)) {
      successes.push_back({&e, atoms_.TrueIn(e.before)});
    }
  }
  return successes;
}

/// Literals that held before each success, or nearly.
std::vector<rules::Literal> Specialization::SharedLiterals(
    const rules::Rule& rule, std::span<const Success> successes) const {
  const std::ptrdiff_t num_successes = std::ssize(successes);
  std::vector<rules::Literal> shared;
  ForEachLiteral(
      TermsOf(rule, *world_), *world_, [&](const rules::Literal& literal) {
        if (!NamesVariable(literal) && num_successes < params_.num_for_others) {
          return;
        }
        if (NamesNothing(literal) &&
            std::ranges::count(params_.landmarks, literal.symbol) == 0) {
          return;
        }
        const bool is_true = literal.comparison == Comparison::kTrue;
        const auto num_exceptions =
            std::ranges::count_if(successes, [&](const Success& success) {
              return success.before.Has(atoms_.IndexOf(
                         literal, success.experience->act.arguments)) !=
                     is_true;
            });
        if (num_exceptions * kSuccessesPerException <= num_successes) {
          shared.push_back(literal);
        }
      });
  return shared;
}

/// True if the literal does not hold in some state, for some objects of the
/// action, or ChangesOfOthers().
bool Specialization::IsTelling(const rules::Literal& literal,
                               std::span<const std::vector<int>> bindings,
                               const SeenAtoms& seen) const {
  if (ChangesOfOthers(literal, seen)) return true;
  return std::ranges::any_of(bindings, [&](const auto& binding) {
    const int atom = atoms_.IndexOf(literal, binding);
    return literal.comparison == Comparison::kTrue ? !seen.always.Has(atom)
                                                   : seen.ever.Has(atom);
  });
}

/// True if the literal says of one argument that a predicate is true, which has
/// been both true and false of some object: what was never seen to change of an
/// action's own objects may change nevertheless, as it does of others.
bool Specialization::ChangesOfOthers(const rules::Literal& literal,
                                     const SeenAtoms& seen) const {
  if (literal.comparison != Comparison::kTrue || literal.terms.size() != 1 ||
      !NamesVariable(literal)) {
    return false;
  }
  for (int object = 0; object < world_->num_objects(); ++object) {
    const int atom = atoms_.IndexOf(
        {literal.symbol, {{rules::Term::Kind::kObject, object}}}, {});
    if (seen.ever.Has(atom) && !seen.always.Has(atom)) return true;
  }
  return false;
}

}  // namespace cell
