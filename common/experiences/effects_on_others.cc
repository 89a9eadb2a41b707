#include "common/experiences/effects_on_others.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/experiences/literal_space.h"
#include "common/experiences/rule_lessons.h"
#include "common/rules/learning/bit_set.h"

namespace cell {
namespace {

using rules::Comparison;
using rules::Experience;

/// Experiences that must agree on an effect.
constexpr size_t kLeastExperiences = 2;
constexpr size_t kMostLiterals = 4;
/// Share of examples that may contradict an effect: what was sensed wrongly.
constexpr double kMostContradicting = 0.02;

struct Explained {
  const Experience* experience;
  std::vector<int> binding;
};

/// An object whose atom an experience may have changed.
struct Example {
  size_t experience = 0;  ///< of those that are explained
  int object = 0;
  bool is_positive = false;
};

bool Names(const rules::Literal& literal, int variable) {
  return std::ranges::any_of(literal.terms, [&](const rules::Term& term) {
    return term.kind == rules::Term::Kind::kVariable && term.index == variable;
  });
}

/// The types of a task, for one quantified variable.
class VariableTypes {
 public:
  VariableTypes(const RuleWorld& world, int variable)
      : world_(world), variable_(variable) {}

  bool IsObjectOf(int object, int type) const {
    return world_.vocabulary().IsOf(world_.ObjectOf(object), type);
  }
  /// The type that the literal wants of the variable; object if it names none.
  int Wanted(const rules::Literal& literal) const {
    int type = TypeHierarchy::kObject;
    const std::vector<int>& types = ArgumentTypes(literal.symbol);
    for (size_t i = 0; i < literal.terms.size(); ++i) {
      if (Names({0, {literal.terms[i]}, Comparison::kTrue, 0}, variable_)) {
        type = Narrower(type, types[i]);
      }
    }
    return type;
  }
  /// The variable's type by a change and conditions.
  int TypeBy(const rules::Literal& change,
             const std::vector<rules::Literal>& where) const {
    int type = Wanted(change);
    for (const rules::Literal& literal : where) {
      if (literal.comparison != Comparison::kTrue) continue;
      type = Narrower(type, Wanted(literal));
      type = Narrower(type, NamedType(literal));
    }
    return type;
  }
  /// Negated literals are defined for all objects of the variable's type.
  bool AreDefined(const rules::Literal& change,
                  const std::vector<rules::Literal>& where) const {
    const int type = TypeBy(change, where);
    return std::ranges::all_of(where, [&](const rules::Literal& literal) {
      return Hierarchy().IsA(type, Wanted(literal));
    });
  }

 private:
  const TypeHierarchy& Hierarchy() const { return world_.vocabulary().types(); }
  int Narrower(int a, int b) const { return Hierarchy().IsA(b, a) ? b : a; }
  /// The type that "peg(P)" names.
  int NamedType(const rules::Literal& literal) const {
    const auto type =
        Hierarchy().Find(world_.world()->symbols()[literal.symbol].name);
    return literal.terms.size() == 1 && type ? *type : TypeHierarchy::kObject;
  }
  const std::vector<int>& ArgumentTypes(int symbol) const {
    const Vocabulary& vocabulary = world_.vocabulary();
    if (const auto predicate = world_.PredicateOf(symbol)) {
      return vocabulary.predicates()[static_cast<size_t>(*predicate)]
          .argument_types;
    }
    return vocabulary
        .static_relations()[static_cast<size_t>(*world_.StaticOf(symbol))]
        .argument_types;
  }

  const RuleWorld& world_;
  int variable_;
};

/// Finds the conditions under which one atom of an object changes.
class ConditionSearch {
 public:
  ConditionSearch(const std::vector<Explained>& explained,
                  const rules::Literal& change,
                  const std::vector<rules::Literal>& candidates,
                  const VariableTypes& types, const rules::World& world)
      : explained_(explained), change_(change), types_(types), world_(world) {
    FindExamples();
    if (positive_.IsEmpty()) return;
    for (const rules::Literal& literal : candidates) {
      rules::BitSet holds(size());
      for (int i = 0; i < size(); ++i) {
        if (Holds(literal, examples_[static_cast<size_t>(i)])) holds.Add(i);
      }
      literals_.push_back({literal, std::move(holds)});
    }
  }

  std::vector<std::vector<rules::Literal>> Run() const {
    std::vector<std::vector<rules::Literal>> found;
    rules::BitSet open = positive_;
    while (IsSupported(open)) {
      const auto condition = Prune(Grow(open));
      rules::BitSet covered = CoveredBy(condition);
      rules::BitSet negative = covered;
      negative -= positive_;
      covered &= open;
      const double share =
          negative.Count() /
          static_cast<double>(std::max(1, negative.Count() + covered.Count()));
      if (!IsSupported(covered) || share > kMostContradicting) break;
      std::vector<rules::Literal> where;
      for (const size_t i : condition) where.push_back(literals_[i].literal);
      found.push_back(std::move(where));
      open -= covered;
    }
    return found;
  }

 private:
  struct Candidate {
    rules::Literal literal;
    rules::BitSet holds;
  };
  using Condition = std::vector<size_t>;  // literals, in order

  int size() const { return static_cast<int>(examples_.size()); }

  void FindExamples() {
    const int type = types_.Wanted(change_);
    const bool is_true = change_.comparison == Comparison::kTrue;
    std::vector<bool> is_positive;
    for (size_t e = 0; e < explained_.size(); ++e) {
      const Experience& experience = *explained_[e].experience;
      for (int object = 0; object < world_.num_objects(); ++object) {
        if (!types_.IsObjectOf(object, type)) continue;
        const int place = PlaceFor(explained_[e], object);
        if (rules::World::Get(experience.before, place) == is_true) continue;
        const bool has_changed =
            rules::World::Get(experience.after, place) == is_true;
        const bool is_argument =
            std::ranges::count(experience.act.arguments, object) > 0;
        // What an argument changes, the outcome says already.
        if (is_argument && has_changed) continue;
        examples_.push_back({e, object, has_changed});
      }
    }
    positive_ = rules::BitSet(size());
    for (int i = 0; i < size(); ++i) {
      if (examples_[static_cast<size_t>(i)].is_positive) positive_.Add(i);
    }
  }

  int PlaceFor(const Explained& explained, int object) const {
    std::vector<int> objects;
    for (const rules::Term& term : change_.terms) {
      const auto i = static_cast<size_t>(term.index);
      objects.push_back(i < explained.binding.size() ? explained.binding[i]
                                                     : object);
    }
    return world_.PlaceOf(change_.symbol, objects);
  }

  bool Holds(const rules::Literal& literal, const Example& example) const {
    const Explained& explained = explained_[example.experience];
    std::vector<int> binding = explained.binding;
    binding.push_back(example.object);
    return rules::Holds(literal, binding, explained.experience->before, world_);
  }

  rules::BitSet CoveredBy(const Condition& condition) const {
    rules::BitSet covered(size(), true);
    for (const size_t i : condition) covered &= literals_[i].holds;
    return covered;
  }

  bool IsSupported(const rules::BitSet& positive) const {
    std::set<size_t> experiences;
    positive.ForEach([&](int i) {
      experiences.insert(examples_[static_cast<size_t>(i)].experience);
    });
    return experiences.size() >= kLeastExperiences;
  }

  bool IsDefined(const Condition& condition) const {
    std::vector<rules::Literal> where;
    for (const size_t i : condition) where.push_back(literals_[i].literal);
    return types_.AreDefined(change_, where);
  }

  /// Adds the literal that gains most information about the open examples.
  Condition Grow(const rules::BitSet& open) const {
    Condition condition;
    rules::BitSet covered = open;
    rules::BitSet negative(size(), true);
    negative -= positive_;
    covered |= negative;
    while (covered.Meets(negative) && condition.size() < kMostLiterals) {
      std::optional<size_t> best;
      double best_gain = 1e-9;
      for (size_t i = 0; i < literals_.size(); ++i) {
        const double gain = Gain(covered, literals_[i].holds);
        if (gain <= best_gain) continue;
        Condition longer = condition;
        longer.push_back(i);
        if (!IsDefined(longer)) continue;
        best_gain = gain;
        best = i;
      }
      if (!best) break;
      condition.push_back(*best);
      covered &= literals_[*best].holds;
    }
    return condition;
  }

  /// FOIL's: what is learned of each positive example that stays covered.
  double Gain(const rules::BitSet& covered, const rules::BitSet& holds) const {
    rules::BitSet rest = covered;
    rest &= holds;
    const double positive = rest.CountWith(positive_);
    if (positive == 0) return 0;
    return positive * (std::log(positive / rest.Count()) -
                       std::log(covered.CountWith(positive_) /
                                static_cast<double>(covered.Count())));
  }

  /// Without literals that exclude no negative example, the latest first.
  Condition Prune(Condition condition) const {
    const auto num_negative = [&](const Condition& c) {
      rules::BitSet covered = CoveredBy(c);
      covered -= positive_;
      return covered.Count();
    };
    const int least = num_negative(condition);
    for (size_t i = condition.size(); i-- > 0;) {
      Condition shorter = condition;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
      if (num_negative(shorter) <= least && IsDefined(shorter)) {
        condition = shorter;
      }
    }
    return condition;
  }

  const std::vector<Explained>& explained_;
  const rules::Literal& change_;
  const VariableTypes& types_;
  const rules::World& world_;
  std::vector<Example> examples_;
  rules::BitSet positive_;
  std::vector<Candidate> literals_;
};

std::string FreeVariableName(const rules::Rule& rule) {
  for (char name = 'P'; name <= 'W'; ++name) {
    bool is_used = false;
    for (int i = 0; i < rule.num_variables(); ++i) {
      is_used |= rule.VariableName(i) == std::string(1, name);
    }
    if (!is_used) return std::string(1, name);
  }
  return "Other";
}

/// Literals of the variable, of the arguments, and of landmarks.
std::vector<rules::Literal> CandidatesFor(const rules::Rule& rule,
                                          std::span<const int> landmarks,
                                          const rules::World& world) {
  std::vector<rules::Term> terms = {
      {rules::Term::Kind::kVariable, rule.num_variables()}};
  for (const rules::Term& term : ArgumentTerms(rule)) terms.push_back(term);
  terms.push_back({rules::Term::Kind::kAny, 0});
  std::vector<rules::Literal> of_variable;
  std::vector<rules::Literal> others;
  ForEachLiteral(terms, world, [&](const rules::Literal& literal) {
    if (Names(literal, rule.num_variables())) {
      of_variable.push_back(literal);
    } else if (!NamesNothing(literal) ||
               std::ranges::count(landmarks, literal.symbol) > 0) {
      others.push_back(literal);
    }
  });
  of_variable.insert(of_variable.end(), others.begin(), others.end());
  return of_variable;
}

/// All atoms with the variable once and arguments else, true and false.
std::vector<rules::Literal> PossibleChanges(const rules::Rule& rule,
                                            const RuleWorld& world) {
  const int variable = rule.num_variables();
  std::vector<rules::Term> terms = {{rules::Term::Kind::kVariable, variable}};
  for (const rules::Term& term : ArgumentTerms(rule)) terms.push_back(term);
  std::vector<rules::Literal> changes;
  ForEachLiteral(terms, *world.world(), [&](const rules::Literal& literal) {
    const auto num = std::ranges::count(literal.terms, terms.front());
    if (num == 1 && world.PredicateOf(literal.symbol)) {
      changes.push_back(literal);
    }
  });
  return changes;
}

std::vector<Explained> ExplainedBy(const rules::Outcome& outcome,
                                   const rules::Rule& rule,
                                   std::span<const Experience> experiences,
                                   const RuleWorld& world) {
  std::vector<Explained> explained;
  for (const Experience& e : experiences) {
    if (e.act.action != rule.action) continue;
    const auto binding =
        rules::Bind(rule, e.act.arguments, e.before, *world.world());
    if (!binding) continue;
    const rules::Outcome own{outcome.probability, outcome.changes};
    if (rules::Apply(own, *binding, e.before, *world.world()) ==
        OwnChanges(e, world).after) {
      explained.push_back({&e, *binding});
    }
  }
  return explained;
}

}  // namespace

void AddEffectsOnOthers(std::span<const Experience> experiences,
                        std::span<const int> landmarks, const RuleWorld& world,
                        rules::Rule* rule) {
  const std::string variable = FreeVariableName(*rule);
  const VariableTypes types(world, rule->num_variables());
  const auto candidates = CandidatesFor(*rule, landmarks, *world.world());
  for (rules::Outcome& outcome : rule->outcomes) {
    if (outcome.changes.empty()) continue;
    const auto explained = ExplainedBy(outcome, *rule, experiences, world);
    for (const rules::Literal& change : PossibleChanges(*rule, world)) {
      const ConditionSearch search(explained, change, candidates, types,
                                   *world.world());
      for (auto& where : search.Run()) {
        outcome.each.push_back({variable, std::move(where), change});
      }
    }
  }
}

}  // namespace cell
