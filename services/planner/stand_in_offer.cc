#include "services/planner/stand_in_offer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "common/sec/stand_in_proposal.h"

namespace cell::planner {
namespace {

/// A part that an action needs otherwise than it is.
struct MissingPart {
  int object = 0;
  GroundAction action;  ///< that moves it
};

bool Concerns(const RequiredChange& change, int object,
              const Vocabulary& vocabulary) {
  return std::ranges::count(vocabulary.Atom(change.atom).objects, object) > 0;
}

/// In the order of the question's changes, each part once.
std::vector<MissingPart> MissingParts(const SecModels& models,
                                      const RuleSet& rules,
                                      const ExecutionStatus& question) {
  std::vector<MissingPart> parts;
  for (const RequiredChange& change : question.needed) {
    if (!change.needed_by || change.truth != Truth::kTrue) continue;
    const auto model = models.find(rules.ActionOf(*change.needed_by).name);
    if (model == models.end()) continue;
    const int moved = change.needed_by->arguments.at(model->second.moved);
    if (!Concerns(change, moved, rules.vocabulary())) continue;
    if (std::ranges::find(parts, moved, &MissingPart::object) == parts.end()) {
      parts.push_back({moved, *change.needed_by});
    }
  }
  return parts;
}

/// What is asked of the part, but for what only arms need, is so of the other.
bool IsAtHand(int other, int part, const ExecutionStatus& question,
              const State& state, const Vocabulary& vocabulary) {
  return std::ranges::all_of(
      question.needed, [&](const RequiredChange& change) {
        GroundAtom atom = vocabulary.Atom(change.atom);
        const Predicate& predicate = vocabulary.predicates()[atom.predicate];
        if (predicate.report || !Concerns(change, part, vocabulary)) {
          return true;
        }
        std::ranges::replace(atom.objects, part, other);
        const auto index = vocabulary.AtomIndex(atom.predicate, atom.objects);
        return !index || state.Get(*index) == change.truth;
      });
}

/// @param all  the models without their names
std::vector<int> StandInsFor(const MissingPart& part, const SecModels& models,
                             std::span<const LearnedModel> all,
                             const RuleSet& rules, const State& state,
                             const ExecutionStatus& question) {
  std::vector<int> objects =
      ProposeStandIns(models.at(rules.ActionOf(part.action).name), all,
                      part.action.arguments, state, rules.vocabulary());
  std::erase_if(objects, [&](int object) {
    return !IsAtHand(object, part.object, question, state, rules.vocabulary());
  });
  return objects;
}

bool AsksOnlyFor(int object, const ExecutionStatus& question,
                 const Vocabulary& vocabulary) {
  return std::ranges::all_of(question.needed, [&](const auto& change) {
    return Concerns(change, object, vocabulary);
  });
}

}  // namespace

void OfferStandIns(const SecModels& models, const RuleSet& rules,
                   const State& state, ExecutionStatus* question) {
  const Vocabulary& vocabulary = rules.vocabulary();
  const std::vector<MissingPart> parts = MissingParts(models, rules, *question);
  std::vector<LearnedModel> all;
  if (!parts.empty()) {
    std::ranges::transform(models, std::back_inserter(all),
                           [](const auto& named) { return named.second; });
  }
  for (const MissingPart& part : parts) {
    const std::vector<int> objects =
        StandInsFor(part, models, all, rules, state, *question);
    if (objects.empty()) continue;
    std::vector<std::string> names;
    for (const int object : objects) {
      names.push_back(vocabulary.objects()[object].name);
    }
    question->text +=
        fmt::format("; {} could stand in for {}", fmt::join(names, " or "),
                    vocabulary.objects()[part.object].name);
    if (question->step || !AsksOnlyFor(part.object, *question, vocabulary)) {
      continue;
    }
    question->step = part.action;
    std::ranges::replace(question->step->arguments, part.object,
                         objects.front());
  }
}

}  // namespace cell::planner
