// What the person of a script does besides placing parts.
#include <algorithm>
#include <numbers>

#include "services/vtb/demonstrator.h"

namespace cell::vtb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kOutsideBy = 0.12;    // [m] beyond the workspace
constexpr double kLayTilt = 1.05;      // [rad] it falls over from here
constexpr double kCorrectAfter = 2.0;  // [s] that a mistake stays
constexpr int kAttemptsInARow = 5;

}  // namespace

/// The event that is due, or later if it cannot be now.
void Demonstrator::StartEvent(World& world) {
  if (!to_correct_.empty()) {
    if (TakeBack(to_correct_, world)) to_correct_.clear();
    return;
  }
  if (explorer_.is_busy()) return Explore(world);
  Event event = events_.front();
  events_.erase(events_.begin());
  if (Start(event.kind, world)) return;
  event.when = NumDone() + 1;
  if (event.when >= static_cast<int>(placements_.size())) return;
  events_.push_back(event);
  std::ranges::stable_sort(events_, {}, &Event::when);
}

bool Demonstrator::Start(EventKind kind, World& world) {
  switch (kind) {
    case EventKind::kTakeBack: {
      std::vector<size_t> candidates;
      for (size_t i = 0; i < placements_.size(); ++i) {
        const Placement& placement = placements_[i];
        if (placement.state == Placement::State::kDone && IsLoose(placement) &&
            std::ranges::count(script_->take_back_of, placement.rule->name) >
                0) {
          candidates.push_back(i);
        }
      }
      if (candidates.empty()) return false;
      return TakeBack({AnyOf(candidates)}, world);
    }
    case EventKind::kUnknownMove:
      return MoveAside(world);
    case EventKind::kTooEarly:
      return PlaceTooEarly(world);
    case EventKind::kTryOut:
      explorer_.Begin(kAttemptsInARow);
      return true;
    case EventKind::kLayOutside:
      return LayOutside(world);
    case EventKind::kLayDown:
      return LayDown(world);
  }
  return false;
}

/// Puts the part of one of the placements back on the table.
bool Demonstrator::TakeBack(const std::vector<size_t>& candidates,
                            World& world) {
  Placement& placement = placements_[AnyOf(candidates)];
  const auto X_WO = PlaceFor(placement.part, kMinMove, world);
  if (!X_WO) return false;
  PutOnTable(placement.part, placement.site, {nullptr, "", *X_WO});
  placement.state = Placement::State::kOpen;
  placement.part.clear();
  return true;
}

bool Demonstrator::MoveAside(World& world) {
  std::vector<std::string> parts;
  for (const Part& part : world.table().parts()) {
    if (std::ranges::count(FreeParts(part.type, world), part.name) > 0) {
      parts.push_back(part.name);
    }
  }
  std::ranges::shuffle(parts, random_);
  for (const std::string& part : parts) {
    if (const auto X_WO = PlaceFor(part, kMinMove, world)) {
      PutOnTable(part, "", {nullptr, "", *X_WO});
      return true;
    }
  }
  return false;
}

bool Demonstrator::PlaceTooEarly(World& world) {
  for (size_t i = 0; i < placements_.size(); ++i) {
    const Placement& placement = placements_[i];
    if (placement.rule->name != *script_->too_early ||
        placement.state != Placement::State::kOpen ||
        IsReady(placement, false)) {
      continue;
    }
    if (!StartPlacing(hands_.front(), i, false, world)) return false;
    hands_.front().actor.Pause(kCorrectAfter);
    to_correct_.push_back(i);
    return true;
  }
  return false;
}

/// The next attempt, or takes back a part that an attempt has seated.
void Demonstrator::Explore(World& world) {
  HandActor& actor = hands_.front().actor;
  if (const auto seated = explorer_.ToTakeBack(random_)) {
    PutOnTable(seated->part, seated->site, {nullptr, "", seated->X_WO});
    explorer_.TakenBack();
    return;
  }
  const auto attempt = explorer_.Next(PossibleAttempts(world), random_);
  if (!attempt) return;
  Target target{attempt->rule, attempt->site};
  target.X_WO_else = attempt->X_WO;
  actor.PickUp(attempt->part, "");
  actor.Place(attempt->part, target);
  actor.GoToRest();
}

/// All but what the script would do next anyway.
std::vector<Attempt> Demonstrator::PossibleAttempts(const World& world) const {
  std::vector<std::string> in_place;
  for (const Placement& placement : placements_) {
    in_place.push_back(placement.part);
  }
  const auto is_next = [&](const PlacementRule& rule, const std::string& site) {
    return std::ranges::any_of(placements_, [&](const Placement& placement) {
      return placement.rule == &rule && placement.site == site &&
             placement.state == Placement::State::kOpen &&
             IsReady(placement, false);
    });
  };
  std::vector<Attempt> attempts;
  for (const std::string& name : script_->place) {
    const PlacementRule& rule = demonstrations_->rules.at(name);
    const auto sites = SitesToTry(rule, *demonstrations_, in_place, world);
    for (const std::string& part : FreeParts(rule.part_type, world)) {
      if (explorer_.IsSeatedByAttempt(part)) continue;
      for (const std::string& site : sites) {
        if (is_next(rule, site)) continue;
        attempts.push_back({&rule, part, site, world.PoseOf(part)});
      }
    }
  }
  return attempts;
}

bool Demonstrator::LayOutside(World& world) {
  const auto part = AnyFreePart(script_->lay_outside, world);
  if (!part) return false;
  const CellLayout& layout = world.layout();
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  Target target;
  target.X_WO.translation() << layout.workspace.max().x() + kOutsideBy,
      layout.parts_area.centre.y() + layout.parts_area.size.y() * unit(random_),
      0;
  target.X_WO.linear() =
      AngleAxisd(2 * std::numbers::pi * unit(random_), Vector3d::UnitZ())
          .toRotationMatrix();
  target.tilt = kLayTilt;
  PutOnTable(*part, "", target);
  is_over_ = true;
  return true;
}

bool Demonstrator::LayDown(World& world) {
  const auto part = AnyFreePart(script_->lay_down, world);
  if (!part) return false;
  const auto X_WO = PlaceFor(*part, kMinMove, world);
  if (!X_WO) return false;
  PutOnTable(*part, "", {nullptr, "", *X_WO, kLayTilt});
  is_over_ = true;
  return true;
}

std::optional<std::string> Demonstrator::AnyFreePart(
    const std::vector<std::string>& types, const World& world) {
  std::vector<std::string> parts;
  for (const std::string& type : types) {
    for (const std::string& part : FreeParts(type, world)) {
      parts.push_back(part);
    }
  }
  if (parts.empty()) return std::nullopt;
  return AnyOf(parts);
}

std::optional<Isometry3d> Demonstrator::PlaceFor(const std::string& part,
                                                 double min_way,
                                                 const World& world) {
  std::vector<PlacementSampler::Placed> scene;
  for (const Part& other : world.table().parts()) {
    scene.push_back({other.name, world.PoseOf(other.name)});
  }
  return sampler_->FreePlace(part, scene, min_way, random_);
}

void Demonstrator::PutOnTable(const std::string& part,
                              const std::string& from_site,
                              const Target& target) {
  HandActor& actor = hands_[std::uniform_int_distribution<size_t>(
                                0, hands_.size() - 1)(random_)]
                         .actor;
  actor.PickUp(part, from_site);
  actor.Place(part, target);
  actor.GoToRest();
}

}  // namespace cell::vtb
