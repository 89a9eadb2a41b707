#include "common/experiences/condition_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace cell {
namespace {

constexpr size_t kMostLiterals = 4;
/// One experience may contradict so many others: it was sensed wrongly.
constexpr size_t kSupportPerContradiction = 8;

}  // namespace

ConditionSearch::ConditionSearch(
    const std::vector<BoundExperience>& experiences,
    const rules::Literal& change, const std::vector<rules::Literal>& candidates,
    std::span<const int> landmarks, const VariableTypes& types,
    const rules::QuantifiedAtoms& atoms, const rules::World& world)
    : experiences_(experiences),
      change_(change),
      types_(types),
      atoms_(atoms),
      world_(world) {
  FindExamples();
  if (positive_.IsEmpty()) return;
  for (const rules::Literal& literal : candidates) {
    const bool is_landmark = literal.comparison == rules::Comparison::kTrue &&
                             types_.IsNamedBy(literal) &&
                             std::ranges::count(landmarks, literal.symbol) > 0;
    literals_.push_back({literal, ExamplesWith(literal), is_landmark});
  }
}

std::vector<std::vector<rules::Literal>> ConditionSearch::Run() {
  std::map<Condition, std::vector<int>> objects_of;
  for (const int type : TypesOfPositive()) {
    within_ = rules::BitSet(size());
    for (int i = 0; i < size(); ++i) {
      const int object = examples_[static_cast<size_t>(i)].object;
      if (types_.TypeOf(object) == type) within_.Add(i);
    }
    for (Condition& condition : FindConditions()) {
      rules::BitSet covered = CoveredBy(condition);
      covered &= positive_;
      std::vector<int>& objects = objects_of[condition];
      covered.ForEach([&](int i) {
        objects.push_back(examples_[static_cast<size_t>(i)].object);
      });
    }
  }
  std::vector<std::vector<rules::Literal>> found;
  for (const auto& [condition, objects] : objects_of) {
    found.push_back(LiteralsOf(WithType(condition, objects)));
  }
  return found;
}

std::set<int> ConditionSearch::TypesOfPositive() const {
  std::set<int> types;
  positive_.ForEach([&](int i) {
    types.insert(types_.TypeOf(examples_[static_cast<size_t>(i)].object));
  });
  return types;
}

/// Of the examples within one type.
std::vector<ConditionSearch::Condition> ConditionSearch::FindConditions()
    const {
  std::vector<Condition> found;
  rules::BitSet open = positive_;
  open &= within_;
  while (IsSupported(open)) {
    Condition condition = Prune(Grow(open, BestLandmark(open)));
    if (!IsAgreed(condition, open)) {
      condition = Prune(Grow(open, std::nullopt));
    }
    // What the conditions so far leave over does not extend to everything.
    const bool is_left_over = condition.empty() && !found.empty();
    if (is_left_over || !IsAgreed(condition, open)) break;
    open -= CoveredBy(condition);
    std::ranges::sort(condition);
    found.push_back(std::move(condition));
  }
  return found;
}

void ConditionSearch::FindExamples() {
  const int type = types_.Wanted(change_);
  const bool is_true = change_.comparison == rules::Comparison::kTrue;
  for (size_t e = 0; e < experiences_.size(); ++e) {
    const rules::Experience& experience = *experiences_[e].experience;
    for (int object = 0; object < world_.num_objects(); ++object) {
      if (!types_.IsObjectOf(object, type)) continue;
      const int place = PlaceFor(experiences_[e], object);
      if (rules::World::Get(experience.before, place) == is_true) continue;
      const bool has_changed =
          rules::World::Get(experience.after, place) == is_true;
      // What an argument changes, the outcome says already.
      const bool is_argument =
          std::ranges::count(experience.act.arguments, object) > 0;
      if (is_argument && has_changed) continue;
      examples_.push_back({e, object, has_changed});
    }
  }
  positive_ = rules::BitSet(size());
  for (int i = 0; i < size(); ++i) {
    if (examples_[static_cast<size_t>(i)].is_positive) positive_.Add(i);
  }
}

int ConditionSearch::PlaceFor(const BoundExperience& bound, int object) const {
  std::vector<int> objects;
  for (const rules::Term& term : change_.terms) {
    const auto i = static_cast<size_t>(term.index);
    objects.push_back(i < bound.binding.size() ? bound.binding[i] : object);
  }
  return world_.PlaceOf(change_.symbol, objects);
}

/// The examples before which the literal holds.
rules::BitSet ConditionSearch::ExamplesWith(
    const rules::Literal& literal) const {
  const bool is_true = literal.comparison == rules::Comparison::kTrue;
  rules::BitSet holding(size());
  std::vector<int> binding;
  for (size_t i = 0; i < examples_.size(); ++i) {
    const auto& [e, object, is_positive] = examples_[i];
    if (i == 0 || examples_[i - 1].experience != e) {
      binding = experiences_[e].binding;
      binding.push_back(object);
    }
    binding.back() = object;
    if (experiences_[e].before.Has(atoms_.IndexOf(literal, binding)) ==
        is_true) {
      holding.Add(static_cast<int>(i));
    }
  }
  return holding;
}

rules::BitSet ConditionSearch::CoveredBy(const Condition& condition) const {
  rules::BitSet covered = within_;
  for (const size_t i : condition) covered &= literals_[i].holds;
  return covered;
}

size_t ConditionSearch::NumExperiences(const rules::BitSet& examples) const {
  std::set<size_t> experiences;
  examples.ForEach([&](int i) {
    experiences.insert(examples_[static_cast<size_t>(i)].experience);
  });
  return experiences.size();
}

/// Enough experiences support it, and hardly any contradicts.
bool ConditionSearch::IsAgreed(const Condition& condition,
                               const rules::BitSet& open) const {
  rules::BitSet negative = CoveredBy(condition);
  rules::BitSet positive = negative;
  negative -= positive_;
  positive &= open;
  return IsSupported(positive) &&
         NumExperiences(negative) * kSupportPerContradiction <=
             NumExperiences(positive);
}

std::vector<rules::Literal> ConditionSearch::LiteralsOf(
    const Condition& condition) const {
  std::vector<rules::Literal> literals;
  for (const size_t i : condition) literals.push_back(literals_[i].literal);
  return literals;
}

/// From a landmark on, if there is one: adds the literal that gains most
/// information, one after the other.
ConditionSearch::Condition ConditionSearch::Grow(
    const rules::BitSet& open, std::optional<size_t> landmark) const {
  Condition condition;
  rules::BitSet negative = within_;
  negative -= positive_;
  rules::BitSet covered = open;
  covered |= negative;
  if (landmark) {
    condition.push_back(*landmark);
    covered &= literals_[*landmark].holds;
  }
  // What contradicts an agreed condition may have been sensed wrongly: then
  // only the object itself can explain it.
  while (covered.Meets(negative) && condition.size() < kMostLiterals) {
    const auto best =
        BestLiteral(condition, covered, IsAgreed(condition, open));
    if (!best) break;
    condition.push_back(*best);
    covered &= literals_[*best].holds;
  }
  return condition;
}

/// The one that holds of most of them.
std::optional<size_t> ConditionSearch::BestLandmark(
    const rules::BitSet& open) const {
  std::optional<size_t> best;
  int most = 0;
  for (size_t i = 0; i < literals_.size(); ++i) {
    if (!literals_[i].is_landmark) continue;
    rules::BitSet covered = open;
    covered &= literals_[i].holds;
    if (covered.Count() <= most || !IsSupported(covered)) continue;
    most = covered.Count();
    best = i;
  }
  return best;
}

std::optional<size_t> ConditionSearch::BestLiteral(const Condition& condition,
                                                   const rules::BitSet& covered,
                                                   bool is_of_object) const {
  std::optional<size_t> best;
  double best_gain = 1e-9;
  for (size_t i = 0; i < literals_.size(); ++i) {
    if (is_of_object && !types_.IsNamedBy(literals_[i].literal)) continue;
    const double gain = Gain(covered, literals_[i].holds);
    if (gain <= best_gain) continue;
    Condition longer = condition;
    longer.push_back(i);
    if (!types_.AreDefined(change_, LiteralsOf(longer))) continue;
    best_gain = gain;
    best = i;
  }
  return best;
}

/// FOIL's: what is learned of each positive example that stays covered.
double ConditionSearch::Gain(const rules::BitSet& covered,
                             const rules::BitSet& holds) const {
  rules::BitSet rest = covered;
  rest &= holds;
  const double positive = rest.CountWith(positive_);
  if (positive == 0) return 0;
  const double before = covered.CountWith(positive_);
  return positive * (std::log(positive / rest.Count()) -
                     std::log(before / covered.Count()));
}

/// With the common type of the objects that it was found by.
ConditionSearch::Condition ConditionSearch::WithType(
    Condition condition, const std::vector<int>& objects) const {
  const int type = types_.CommonType(objects);
  if (types_.IsA(KnownType(condition), type)) return condition;
  for (size_t i = 0; i < literals_.size(); ++i) {
    if (!types_.Says(literals_[i].literal, type)) continue;
    condition.insert(condition.begin(), i);
    break;
  }
  return condition;
}

/// The variable's type by the condition. What becomes false is false of objects
/// of other types anyway.
int ConditionSearch::KnownType(const Condition& condition) const {
  const rules::Literal no_change;
  const bool is_true = change_.comparison == rules::Comparison::kTrue;
  return types_.TypeBy(is_true ? no_change : change_, LiteralsOf(condition));
}

/// Without literals that exclude no negative example, the latest first. A
/// landmark that it begins with stays.
ConditionSearch::Condition ConditionSearch::Prune(Condition condition) const {
  const bool is_landmark =
      !condition.empty() && literals_[condition.front()].is_landmark;
  const size_t num_kept = is_landmark ? 1 : 0;
  const auto num_negative = [&](const Condition& c) {
    rules::BitSet covered = CoveredBy(c);
    covered -= positive_;
    return covered.Count();
  };
  const int least = num_negative(condition);
  for (size_t i = condition.size(); i-- > num_kept;) {
    Condition shorter = condition;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
    if (num_negative(shorter) <= least &&
        types_.AreDefined(change_, LiteralsOf(shorter))) {
      condition = shorter;
    }
  }
  return condition;
}

}  // namespace cell
