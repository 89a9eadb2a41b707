#include "services/vtb/explorer.h"

#include <algorithm>
#include <utility>

#include "common/predicates/seat.h"
#include "services/vtb/target.h"

namespace cell::vtb {
namespace {

/// How often the latest part is taken back before the last attempt.
constexpr double kTakeBackEarly = 0.3;

bool IsAtSite(const Attempt& attempt, const World& world) {
  return IsMeantFor(attempt.part, attempt.site, world) &&
         IsSeated(PoseOfSite(attempt.site, world).inverse() *
                      world.PoseOf(attempt.part),
                  0, attempt.rule->seated);
}

template <class T>
const T& AnyItem(const std::vector<T>& items, std::mt19937_64& random) {
  return items[std::uniform_int_distribution<size_t>(0,
                                                     items.size() - 1)(random)];
}

}  // namespace

void Explorer::Book(const World& world) {
  if (!running_) return;
  if (IsAtSite(*running_, world)) {
    seated_.push_back(*running_);
  } else {
    failure_ = {*running_, time_};
  }
  running_.reset();
}

std::optional<FailedAttempt> Explorer::TakeFailure() {
  return std::exchange(failure_, std::nullopt);
}

std::optional<Attempt> Explorer::ToTakeBack(std::mt19937_64& random) const {
  if (seated_.empty()) return std::nullopt;
  if (num_left_ > 0 && !std::bernoulli_distribution(kTakeBackEarly)(random)) {
    return std::nullopt;
  }
  return seated_.back();
}

std::optional<Attempt> Explorer::Next(const std::vector<Attempt>& candidates,
                                      std::mt19937_64& random) {
  if (candidates.empty()) {
    num_left_ = 0;
    return std::nullopt;
  }
  std::vector<std::string> names;
  for (const Attempt& attempt : candidates) {
    if (std::ranges::count(names, attempt.rule->name) == 0) {
      names.push_back(attempt.rule->name);
    }
  }
  const std::string name = AnyItem(names, random);
  std::vector<Attempt> of_rule;
  for (const Attempt& attempt : candidates) {
    if (attempt.rule->name == name) of_rule.push_back(attempt);
  }
  --num_left_;
  time_ = 0;
  running_ = AnyItem(of_rule, random);
  return running_;
}

bool Explorer::IsSeatedByAttempt(const std::string& part) const {
  return std::ranges::any_of(
      seated_, [&](const Attempt& attempt) { return attempt.part == part; });
}

std::vector<std::string> SitesToTry(
    const PlacementRule& rule, const Demonstrations& demonstrations,
    const std::vector<std::string>& parts_in_place, const World& world) {
  std::vector<std::string> types;
  for (const auto& [name, other] : demonstrations.rules) {
    if (&other == &rule ||
        (!rule.called.empty() && other.called == rule.called))
      types.push_back(other.site_type);
  }
  std::vector<std::string> sites;
  for (const Part& host : world.table().parts()) {
    const bool is_in_place =
        !host.is_free() || std::ranges::count(parts_in_place, host.name) > 0;
    if (!is_in_place) continue;
    for (const Site& site : host.sites) {
      if (std::ranges::count(types, site.type) > 0 &&
          ThreadOf(site.name, world) == nullptr) {
        sites.push_back(site.name);
      }
    }
  }
  return sites;
}

}  // namespace cell::vtb
