#include "services/cell/scoring/success_criterion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cell::cli {
namespace {

std::vector<std::string> GoalNames(const Domain& domain) {
  std::vector<std::string> names;
  for (const Goal& goal : domain.goals()) names.push_back(goal.name);
  return names;
}

const std::string& NameOfObject(const Vocabulary& vocabulary, int object) {
  return vocabulary.objects()[static_cast<size_t>(object)].name;
}

/// Arguments of the type are all found by `find`, parts or sites.
template <class Find>
void CheckArgument(const Config& config, const Vocabulary& vocabulary, int type,
                   const char* what, Find find) {
  for (const int object : vocabulary.ObjectsOf(type)) {
    const std::string& name = NameOfObject(vocabulary, object);
    if (find(name) == nullptr) {
      config.Fail(fmt::format("its argument {} is not a {}", name, what));
    }
  }
}

SuccessCriterion::Seat SeatFromConfig(const Config& config,
                                      const Predicate& predicate,
                                      const Vocabulary& vocabulary,
                                      const PartTable& parts) {
  SuccessCriterion::Seat seat{SeatTolerance::FromConfig(config), {}};
  const auto find_site = [&](const std::string& name) {
    return parts.FindSite(name);
  };
  if (config.Has("site")) {
    seat.site = config.Get<std::string>("site");
    if (find_site(*seat.site) == nullptr) {
      config["site"].Fail("no part has the site '" + *seat.site + "'");
    }
  }
  const auto& types = predicate.argument_types;
  if (types.size() != (seat.site ? 1 : 2)) {
    config.Fail(fmt::format(
        "{} has {} arguments; it should have 1 with `site`, 2 without",
        predicate.name, types.size()));
  }
  CheckArgument(config, vocabulary, types[0], "part",
                [&](const std::string& name) { return parts.Find(name); });
  if (!seat.site) {
    CheckArgument(config, vocabulary, types[1], "site", find_site);
  }
  return seat;
}

}  // namespace

SuccessCriterion SuccessCriterion::FromConfig(const Config& config,
                                              const Domain& domain,
                                              const PartTable& parts) {
  const auto name = config.Get<std::string>("goal");
  const Goal* goal = domain.FindGoal(name);
  if (goal == nullptr) {
    config["goal"].Fail(fmt::format("domain.yaml has no goal '{}'; it has: {}",
                                    name, fmt::join(GoalNames(domain), ", ")));
  }
  SuccessCriterion success{parts, domain.vocabulary(), goal->literals, {}};
  for (const auto& [key, entry] : config["seated"].Entries()) {
    const auto index = success.vocabulary.FindPredicate(key);
    if (!index) entry.Fail("domain.yaml has no predicate '" + key + "'");
    success.seats.emplace(
        *index, SeatFromConfig(entry, success.vocabulary.predicates()[*index],
                               success.vocabulary, parts));
  }
  for (const Literal& literal : success.literals) {
    const std::string text = cell::Show(literal, {}, success.vocabulary);
    if (literal.is_static) {
      config["goal"].Fail(text + " never changes: it cannot be part of a goal");
    }
    if (!success.seats.contains(literal.relation)) {
      config["seated"].Fail("does not mention " + text + ", which '" + name +
                            "' wants");
    }
  }
  config.Finish();
  return success;
}

SuccessCriterion SuccessCriterion::Load(const Deployment& deployment) {
  const PartTable parts =
      PartTable::FromConfig(deployment.OfTask("parts.yaml"));
  return FromConfig(deployment.OfTask("success.yaml"),
                    Domain::FromConfig(deployment.OfTask("domain.yaml"), parts),
                    parts);
}

SuccessCriterion SuccessCriterion::ForGoal(const Goal& goal) const {
  for (const Literal& literal : goal.literals) {
    if (literal.is_static || !seats.contains(literal.relation)) {
      throw std::invalid_argument(
          fmt::format("{}, which the goal '{}' wants, cannot be scored: "
                      "success.yaml does not say when it holds",
                      cell::Show(literal, {}, vocabulary), goal.name));
    }
  }
  SuccessCriterion other = *this;
  other.literals = goal.literals;
  return other;
}

const Part& SuccessCriterion::PartOf(const GroundAtom& atom) const {
  return *parts.Find(NameOfObject(vocabulary, atom.objects[0]));
}

const Site& SuccessCriterion::SiteOf(const GroundAtom& atom) const {
  const Seat& seat = seats.at(atom.predicate);
  return *parts.FindSite(seat.site ? *seat.site
                                   : NameOfObject(vocabulary, atom.objects[1]));
}

std::string SuccessCriterion::NameOf(const Literal& literal) const {
  const Seat& seat = seats.at(literal.relation);
  if (seat.site) return *seat.site;
  const Term& site = literal.terms[1];
  return site.kind == Term::Kind::kObject ? NameOfObject(vocabulary, site.index)
                                          : cell::Show(literal, {}, vocabulary);
}

}  // namespace cell::cli
