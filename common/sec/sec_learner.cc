#include "common/sec/sec_learner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "common/sec/role_matching.h"

namespace cell {
namespace {

constexpr std::array kRoleNames = {"X", "Y", "Z", "U", "V"};
static_assert(kRoleNames.size() == kMaxRoles);

LiteralSet OfMovedPart(LiteralSet literals) {
  std::erase_if(literals, [](const Literal& l) { return !Mentions(l, 0); });
  return literals;
}

/// Jaccard index. @pre one of them has something.
double Overlap(const LiteralSet& a, const LiteralSet& b, size_t num_more) {
  const auto num_common = std::count_if(
      a.begin(), a.end(), [&](const Literal& l) { return b.contains(l); });
  return static_cast<double>(num_common) /
         static_cast<double>(a.size() + b.size() + num_more -
                             static_cast<size_t>(num_common));
}

bool IsOfMovedPartAlone(const Literal& literal) {
  return std::ranges::all_of(literal.terms,
                             [](const Term& term) { return term.index == 0; });
}

}  // namespace

SecLearner::SecLearner(std::shared_ptr<const SceneWords> words,
                       std::shared_ptr<const ChainSimilarity> similarity,
                       const Params& params)
    : words_(std::move(words)),
      similarity_(std::move(similarity)),
      params_(params) {}

void SecLearner::CountMadeUp(const std::string& name) {
  if (!IsMadeUp(name)) return;
  size_t number = 0;
  const std::string digits = name.substr(sizeof(kMadeUp) - 1);
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  num_made_up_ = std::max(num_made_up_, number);
}

bool SecLearner::IsMadeUp(const std::string& name) {
  constexpr size_t kLength = sizeof(kMadeUp) - 1;
  return name.starts_with(kMadeUp) && name.size() > kLength &&
         name[kLength] != '0' &&
         std::ranges::all_of(name.substr(kLength),
                             [](char c) { return c >= '0' && c <= '9'; });
}

ShowingGroup* SecLearner::Find(const std::string& name) {
  const auto group = std::ranges::find_if(
      groups_, [&](const auto& g) { return !g.is_gone() && g.name == name; });
  return group == groups_.end() ? nullptr : &*group;
}

void SecLearner::Know(const std::string& name, const LearnedModel& model) {
  CountMadeUp(name);
  RoleMap places;  // role 0 is moved
  size_t next = 1;
  for (size_t i = 0; i < model.roles.size(); ++i) {
    places.push_back(i == model.moved ? 0 : next++);
  }
  ShowingGroup known{.name = name, .is_named = !IsMadeUp(name)};
  for (const Contribution& contribution : model.taught) {
    known.Add(Renamed(contribution, places), types());
  }
  if (model.taught.empty()) {
    std::vector<int> of_roles;
    for (const Variable& role : model.roles) of_roles.push_back(role.type);
    known.Add(Renamed(Contribution{model.shown, "", of_roles, model.pick,
                                   model.place, model.chain},
                      places),
              types());
  }
  if (ShowingGroup* group = Find(name)) {
    *group = std::move(known);
  } else {
    groups_.push_back(std::move(known));
  }
}

std::optional<SecLearner::Lesson> SecLearner::Add(
    const ObservedManipulation& manipulation, const std::string& source,
    const std::string& build) {
  const auto showing = Lift(manipulation, *words_);
  if (!showing) return std::nullopt;
  Match best;
  size_t found = groups_.size();
  for (size_t i = 0; i < groups_.size(); ++i) {
    Match match = MatchOf(groups_[i], *showing, true);
    if (match.similarity < params_.threshold ||
        match.similarity <= best.similarity) {
      continue;
    }
    best = std::move(match);
    found = i;
  }
  const bool is_new = found == groups_.size();
  if (is_new) {
    for (size_t role = 0; role < showing->types.size(); ++role) {
      best.places.push_back(role);
    }
    groups_.push_back({.name = fmt::format("{}{}", kMadeUp, ++num_made_up_),
                       .types = showing->types});
  }
  ShowingGroup& group = groups_[found];
  const bool is_forward = best.direction == ActionDirection::kForward;
  group.Add(ContributionOf(is_forward ? *showing : showing->Reversed(),
                           best.places, group.types.size(), source, build),
            types());
  Lesson lesson{found, best.direction, is_new, Binding(group.types.size(), -1)};
  for (size_t role = 0; role < showing->objects.size(); ++role) {
    if (best.places[role])
      lesson.objects[*best.places[role]] = showing->objects[role];
  }
  return lesson;
}

void SecLearner::Widen(size_t group, const std::vector<int>& wider) {
  ShowingGroup& widened = groups_.at(group);
  if (wider.size() != widened.types.size()) {
    throw std::invalid_argument(fmt::format("{}: {} types for {} roles",
                                            widened.name, wider.size(),
                                            widened.types.size()));
  }
  widened.Widen(wider, types());
}

void SecLearner::TurnAround(Lesson* lesson) {
  ShowingGroup& group = groups_.at(lesson->group);
  group = Reversed(group);
  lesson->direction = lesson->direction == ActionDirection::kForward
                          ? ActionDirection::kReversed
                          : ActionDirection::kForward;
}

Result<size_t> SecLearner::Name(const Lesson& lesson, const std::string& name,
                                bool is_undone) {
  ShowingGroup& shown = groups_.at(lesson.group);
  if (shown.is_gone()) return Reason{"what was shown has been taken back"};
  const bool is_backwards =
      is_undone != (lesson.direction == ActionDirection::kReversed);
  if (shown.is_named) {
    if (shown.name != name) return Reason{"it is known as " + shown.name};
    if (is_backwards) {
      return Reason{name + (is_undone ? " was done, not undone"
                                      : " was undone, not done")};
    }
    return lesson.group;
  }
  ShowingGroup read = is_backwards ? Reversed(shown) : shown;
  ShowingGroup* known = Find(name);
  if (known == nullptr || known == &shown) {
    read.name = name;
    read.is_named = true;
    shown = std::move(read);
    return lesson.group;
  }
  const Match match = MatchOf(*known, read.AsShowing(), false);
  if (match.similarity < params_.threshold ||
      known->types.size() != read.types.size()) {
    return Reason{"it does not change what " + name + " changes"};
  }
  if (match.direction != ActionDirection::kForward) {
    return Reason{
        name + (is_undone ? " was done, not undone" : " was undone, not done")};
  }
  known->Absorb(read, match.places, types());
  known->is_named = true;
  shown = {};
  return static_cast<size_t>(known - groups_.data());
}

Result<bool> SecLearner::Merge(const std::string& name,
                               const std::string& into) {
  ShowingGroup* from = Find(name);
  ShowingGroup* kept = Find(into);
  if (from == nullptr || kept == nullptr) {
    return Reason{"nothing has been learned of " +
                  (from == nullptr ? name : into)};
  }
  if (from == kept) return Reason{name + " is the same action"};
  const Match match = MatchOf(*kept, from->AsShowing(), false);
  if (match.similarity < params_.threshold ||
      kept->types.size() != from->types.size()) {
    return Reason{
        fmt::format("{} does not change what {} changes", name, into)};
  }
  if (match.direction != ActionDirection::kForward) {
    return Reason{fmt::format("{} undoes what {} does", name, into)};
  }
  kept->Absorb(*from, match.places, types());
  *from = {};
  return true;
}

Result<std::vector<std::string>> SecLearner::TakeBack(
    const std::string& demonstration) {
  std::vector<ShowingGroup> left = groups_;
  std::vector<std::string> names;
  for (ShowingGroup& group : left) {
    const auto has_taught = group.TakeBack(demonstration, types());
    if (!has_taught) return Reason{has_taught.reason()};
    if (*has_taught) names.push_back(group.name);
  }
  groups_ = std::move(left);
  return names;
}

void SecLearner::Forget(const std::string& name) {
  CountMadeUp(name);
  if (ShowingGroup* group = Find(name)) *group = {};
}

std::vector<SecLearner::Action> SecLearner::Actions() const {
  std::vector<Action> actions;
  for (const ShowingGroup& group : groups_) {
    if (group.is_gone()) continue;
    actions.push_back({group.name, group.is_named, ModelOf(group)});
  }
  std::ranges::sort(actions, {}, &Action::name);
  return actions;
}

SecLearner::Action SecLearner::ActionOf(const Lesson& lesson) const {
  const ShowingGroup& group = groups_.at(lesson.group);
  return {group.name, group.is_named, ModelOf(group)};
}

SecLearner::Match SecLearner::MatchOf(const ShowingGroup& group,
                                      const Showing& showing,
                                      bool needs_types) const {
  Match best;
  for (const auto direction :
       {ActionDirection::kForward, ActionDirection::kReversed}) {
    const Showing read =
        direction == ActionDirection::kForward ? showing : showing.Reversed();
    ForEachMatching(read.types.size(), group.types.size(),
                    [&](const RoleMap& places) {
                      if (needs_types && !AreTypesKnown(group, read, places))
                        return;
                      const double similarity = Similarity(group, read, places);
                      if (similarity <= best.similarity) return;
                      best = {similarity, direction, places};
                    });
  }
  return best;
}

bool SecLearner::AreTypesKnown(const ShowingGroup& group,
                               const Showing& showing,
                               const RoleMap& places) const {
  for (size_t role = 0; role < places.size(); ++role) {
    if (places[role] && !words_->vocabulary.types().IsA(
                            showing.types[role], group.types[*places[role]])) {
      return false;
    }
  }
  return true;
}

double SecLearner::Similarity(const ShowingGroup& group, const Showing& showing,
                              const RoleMap& places) const {
  const LiteralSet of_showing =
      OfMovedPart(ChangedLiterals(showing.pick, showing.place));
  const LiteralSet of_group =
      OfMovedPart(ChangedLiterals(group.pick, group.place));
  const double chains = similarity_->Between(group.chain, showing.chain);
  if (of_showing.empty() && of_group.empty()) return chains;
  const LiteralSet renamed = Renamed(of_showing, places);
  const double literals =
      Overlap(of_group, renamed, of_showing.size() - renamed.size());
  return params_.literal_share * literals +
         (1 - params_.literal_share) * chains;
}

LearnedModel SecLearner::ModelOf(const ShowingGroup& group) const {
  LearnedModel model;
  for (size_t role = 0; role < group.types.size(); ++role) {
    model.roles.push_back({kRoleNames[role], group.types[role]});
  }
  model.pick = Characteristic(group, true);
  model.place = Characteristic(group, false);
  model.chain = group.chain;
  model.shown = group.Shown();
  model.taught = group.taught;
  return model;
}

/// What changes, what always relates the roles, and what only this action has.
SceneFacts SecLearner::Characteristic(const ShowingGroup& group,
                                      bool at_pick) const {
  const std::set<Partner> partners = ChangedPartners(group.pick, group.place);
  const LiteralSet changed = ChangedLiterals(group.pick, group.place);
  const SceneFacts& all = at_pick ? group.pick : group.place;
  const auto stance_of_literal = [](const Literal& literal) {
    return [&literal](const SceneFacts& facts) {
      if (facts.where.contains(literal)) return Stance::kShares;
      return facts.where.contains(Negated(literal)) ? Stance::kContradicts
                                                    : Stance::kSilent;
    };
  };
  const auto is_idle_literal = [&](const Literal& literal) {
    if (literal.is_static || changed.contains(literal) ||
        changed.contains(Negated(literal))) {
      return false;
    }
    return !IsOfMovedPartAlone(literal) ||
           !IsTelling(group, at_pick, stance_of_literal(literal));
  };
  const auto is_idle_partner = [&](const Partner& partner) {
    if (partners.contains(partner)) return false;
    const bool touches = all.touch.contains(partner);
    return partner.kind != Partner::Kind::kObject ||
           !IsTelling(group, at_pick, [&](const SceneFacts& facts) {
             const bool has_touch = facts.touch.contains(partner);
             if (!has_touch && !facts.apart.contains(partner)) {
               return Stance::kSilent;
             }
             return has_touch == touches ? Stance::kShares
                                         : Stance::kContradicts;
           });
  };
  SceneFacts facts = all;
  std::erase_if(facts.where, is_idle_literal);
  std::erase_if(facts.touch, is_idle_partner);
  std::erase_if(facts.apart, is_idle_partner);
  return facts;
}

/// Some other group contradicts it, and none shares it.
bool SecLearner::IsTelling(
    const ShowingGroup& group, bool at_pick,
    const std::function<Stance(const SceneFacts&)>& stance) const {
  bool is_contradicted = false;
  for (const ShowingGroup& other : groups_) {
    if (&other == &group || other.is_gone()) continue;
    const Stance taken = stance(at_pick ? other.pick : other.place);
    if (taken == Stance::kShares) return false;
    is_contradicted = is_contradicted || taken == Stance::kContradicts;
  }
  return is_contradicted;
}

}  // namespace cell
