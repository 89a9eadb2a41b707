#include "services/vtb/demonstrator.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "services/vtb/target.h"
#include "services/vtb/within_reach.h"

namespace cell::vtb {
namespace {

using Eigen::Vector2d;

double SegmentDistance(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                       const Vector2d& d) {
  // Sampled: the ways are short and the gap is wide.
  constexpr int kSamples = 16;
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const Vector2d p = a + (b - a) * i / kSamples;
      const Vector2d q = c + (d - c) * j / kSamples;
      distance = std::min(distance, (p - q).norm());
    }
  }
  return distance;
}

double DistanceOfWays(const std::vector<Vector2d>& a,
                      const std::vector<Vector2d>& b) {
  double distance = std::numeric_limits<double>::infinity();
  const auto at = [](const std::vector<Vector2d>& way, size_t i) {
    return way[std::min(i, way.size() - 1)];
  };
  for (size_t i = 0; i + 1 < a.size() || i == 0; ++i) {
    for (size_t j = 0; j + 1 < b.size() || j == 0; ++j) {
      distance = std::min(distance, SegmentDistance(at(a, i), at(a, i + 1),
                                                    at(b, j), at(b, j + 1)));
    }
  }
  return distance;
}

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

int Draw(const CountRange& range, std::mt19937_64& random) {
  return std::uniform_int_distribution<int>(range.low, range.high)(random);
}

}  // namespace

Demonstrator::Demonstrator(std::shared_ptr<const Demonstrations> demonstrations,
                           const std::string& script, uint64_t seed,
                           World& world)
    : demonstrations_(std::move(demonstrations)), random_(seed) {
  const auto found = demonstrations_->scripts.find(script);
  if (found == demonstrations_->scripts.end()) {
    throw std::invalid_argument("no demonstration is named '" + script + "'");
  }
  script_ = &found->second;
  sampler_ = std::make_shared<PlacementSampler>(
      world.table(), world.layout(), demonstrations_->human_motion.table_gap);
  world.Reset();
  ScatterParts(world);
  for (const std::string& name : script_->place) {
    const PlacementRule& rule = demonstrations_->rules.at(name);
    auto num_left =
        std::ranges::count(world.table().parts(), rule.part_type, &Part::type);
    for (const Part& host : world.table().parts()) {
      for (const Site& site : host.sites) {
        if (site.type == rule.site_type && num_left-- > 0) {
          placements_.push_back({&rule, site.name, {}, ""});
        }
      }
    }
  }
  // The right hand of a right-handed person comes last in the layout.
  const auto& hands = world.layout().hands;
  for (int i = 1; i <= script_->num_hands; ++i) {
    const std::string& name =
        hands.at(hands.size() - static_cast<size_t>(i)).name;
    hands_.push_back({HandActor(name, demonstrations_->human_motion, world)});
  }
  PlanEvents();
  pause_ = demonstrations_->human_motion.first_pause;
}

/// What begins nowhere else stands where the arms can take it, if they are to.
void Demonstrator::ScatterParts(World& world) {
  PlacementSampler::Starts starts;
  for (const auto& [part, start] : script_->start) {
    if (start.site.empty()) {
      starts.lying.insert(part);
    } else {
      starts.placed.push_back({part, PoseOfSite(start.site, world)});
    }
  }
  PlacementSampler::Accept accept;
  if (script_->agent == "robot") {
    accept = [&, reach = WithinReach(world.table(), world.layout())](
                 const auto& scene) {
      return reach.CanTakeAll(scene, starts);
    };
  }
  for (const auto& placed : sampler_->Scatter(starts, random_, accept)) {
    world.Place(placed.part, placed.X_WO);
  }
}

void Demonstrator::PlanEvents() {
  const int count = static_cast<int>(placements_.size());
  const auto plan = [&](EventKind kind, int earliest, int latest) {
    events_.push_back(
        {kind, std::uniform_int_distribution<int>(earliest, latest)(random_)});
  };
  for (int i = Draw(script_->take_backs, random_); i > 0; --i) {
    plan(EventKind::kTakeBack, 1, std::max(1, count - 3));
  }
  for (int i = Draw(script_->unknown_moves, random_); i > 0; --i) {
    plan(EventKind::kUnknownMove, 0, std::max(0, count - 2));
  }
  if (script_->attempts.high > 0) {
    for (int i = Draw(script_->attempts, random_); i > 0; --i) {
      plan(EventKind::kTryOut, 0, std::max(0, count - 1));
    }
  }
  if (script_->too_early) plan(EventKind::kTooEarly, 0, count / 2);
  if (!script_->lay_outside.empty()) {
    plan(EventKind::kLayOutside, 0, std::max(0, count - 3));
  }
  if (!script_->lay_down.empty()) events_.push_back({EventKind::kLayDown, 0});
  std::ranges::stable_sort(events_, {}, &Event::when);
}

bool Demonstrator::AreHandsIdle() const {
  return std::ranges::all_of(hands_, [](const Hand& hand) {
    return hand.actor.is_idle() && hand.placement < 0;
  });
}

bool Demonstrator::is_done() const {
  const bool is_all = std::ranges::all_of(placements_, [](const Placement& p) {
    return p.state == Placement::State::kDone;
  });
  return AreHandsIdle() && (is_all || is_over_) && to_correct_.empty() &&
         !explorer_.is_busy();
}

std::vector<std::string> Demonstrator::failures() const {
  std::vector<std::string> all;
  for (const Hand& hand : hands_) {
    const auto& failures = hand.actor.failures();
    all.insert(all.end(), failures.begin(), failures.end());
  }
  return all;
}

int Demonstrator::NumDone() const {
  return static_cast<int>(std::ranges::count(
      placements_, Placement::State::kDone, &Placement::state));
}

void Demonstrator::Update(double dt, World& world) {
  pause_ -= dt;
  explorer_.Update(dt);
  BookFinished(world);
  if (pause_ <= 0 && !is_over_) Decide(world);
  for (Hand& hand : hands_) {
    hand.actor.Update(dt, world, *sampler_, random_);
  }
}

/// Planned events, such as mistakes, begin only while both hands are free.
void Demonstrator::Decide(World& world) {
  const bool is_event_running =
      std::ranges::any_of(hands_, [](const Hand& hand) {
        return !hand.actor.is_idle() && hand.placement < 0;
      });
  if (is_event_running) return;
  const bool is_event_due =
      !to_correct_.empty() || explorer_.is_busy() ||
      (!events_.empty() && events_.front().when <= NumDone());
  if (is_event_due && AreHandsIdle()) {
    StartEvent(world);
    return;
  }
  for (Hand& hand : hands_) {
    if (!hand.actor.is_idle()) continue;
    if (hand.is_fetched) {
      CarryOn(hand, world);
    } else if (hand.placement < 0 && !is_event_due) {
      PlaceNext(hand, world);
    }
  }
}

/// Records what the hands have finished.
void Demonstrator::BookFinished(const World& world) {
  if (AreHandsIdle()) explorer_.Book(world);
  for (Hand& hand : hands_) {
    if (!hand.actor.is_idle() || hand.placement < 0 || hand.is_fetched) {
      continue;
    }
    placements_[static_cast<size_t>(hand.placement)].state =
        Placement::State::kDone;
    hand.placement = -1;
    pause_ = std::uniform_real_distribution<double>(
        demonstrations_->human_motion.pause_low,
        demonstrations_->human_motion.pause_high)(random_);
  }
}

/// Whether all that must come first is in place; `soon`: or in a hand.
bool Demonstrator::IsReady(const Placement& placement, bool soon) const {
  return std::ranges::all_of(placements_, [&](const Placement& other) {
    return !Contains(placement.rule->after, other.rule->name) ||
           other.state == Placement::State::kDone ||
           (soon && other.state == Placement::State::kClaimed);
  });
}

/// Whether nothing that was placed needs it to stay.
bool Demonstrator::IsLoose(const Placement& placement) const {
  return std::ranges::none_of(placements_, [&](const Placement& other) {
    return other.state != Placement::State::kOpen &&
           Contains(other.rule->after, placement.rule->name);
  });
}

std::vector<std::string> Demonstrator::FreeParts(const std::string& type,
                                                 const World& world) const {
  std::vector<std::string> free;
  for (const Part& part : world.table().parts()) {
    if (part.type != type || !part.is_free()) continue;
    const bool is_used = std::ranges::any_of(
        placements_, [&](const Placement& p) { return p.part == part.name; });
    if (!is_used) free.push_back(part.name);
  }
  return free;
}

bool Demonstrator::IsWayFree(const HandActor& actor, const World& world) const {
  const std::vector<Vector2d> way = actor.WayAhead(world);
  return std::ranges::all_of(hands_, [&](const Hand& other) {
    return other.actor.hand() == actor.hand() ||
           DistanceOfWays(way, other.actor.WayAhead(world)) >
               demonstrations_->human_motion.hands_gap;
  });
}

/// Keeps what a planned mistake needs: the last condition of the rule to be
/// broken, and one of the parts to be laid outside.
bool Demonstrator::WouldSpoilMistake(const Placement& placement,
                                     const World& world) const {
  const auto is_planned = [&](EventKind kind) {
    return std::ranges::find(events_, kind, &Event::kind) != events_.end();
  };
  if (is_planned(EventKind::kLayOutside) &&
      Contains(script_->lay_outside, placement.rule->part_type)) {
    size_t num_free = 0;
    for (const std::string& type : script_->lay_outside) {
      num_free += FreeParts(type, world).size();
    }
    return num_free <= 1;
  }
  if (!is_planned(EventKind::kTooEarly)) return false;
  const std::vector<std::string>& conditions =
      demonstrations_->rules.at(*script_->too_early).after;
  const auto num_open =
      std::ranges::count_if(placements_, [&](const Placement& p) {
        return p.state == Placement::State::kOpen &&
               Contains(conditions, p.rule->name);
      });
  return num_open <= 1 && Contains(conditions, placement.rule->name);
}

void Demonstrator::PlaceNext(Hand& hand, World& world) {
  std::vector<size_t> ready, soon;
  for (size_t i = 0; i < placements_.size(); ++i) {
    const Placement& placement = placements_[i];
    if (placement.state != Placement::State::kOpen ||
        WouldSpoilMistake(placement, world)) {
      continue;
    }
    if (IsReady(placement, false)) ready.push_back(i);
    if (IsReady(placement, true)) soon.push_back(i);
  }
  if (!ready.empty() && StartPlacing(hand, AnyOf(ready), false, world)) return;
  // The ways cross: at least fetch something while the other hand works.
  if (hands_.size() > 1 && !soon.empty()) {
    StartPlacing(hand, AnyOf(soon), true, world);
  }
}

bool Demonstrator::StartPlacing(Hand& hand, size_t index, bool only_fetch,
                                World& world) {
  Placement& placement = placements_[index];
  const std::string part = AnyOf(FreeParts(placement.rule->part_type, world));
  HandActor trial = hand.actor;
  trial.PickUp(part, "");
  if (!only_fetch) trial.Place(part, {placement.rule, placement.site});
  trial.GoToRest();
  if (!IsWayFree(trial, world)) return false;
  hand = {trial, static_cast<int>(index), only_fetch};
  placement.state = Placement::State::kClaimed;
  placement.part = part;
  return true;
}

/// The hand holds a part at its rest: it goes on when the way is free.
void Demonstrator::CarryOn(Hand& hand, World& world) {
  const Placement& placement = placements_[static_cast<size_t>(hand.placement)];
  if (!IsReady(placement, false)) return;
  HandActor trial = hand.actor;
  trial.Place(placement.part, {placement.rule, placement.site});
  trial.GoToRest();
  if (IsWayFree(trial, world)) hand = {trial, hand.placement, false};
}

}  // namespace cell::vtb
