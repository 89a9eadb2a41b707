#include "services/vtb/disturbance_model.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kRetryAfter = 2;     // [s] if nothing can be done now
constexpr double kFromGripper = 0.3;  // [m] parts nearer to one are left alone
constexpr int kTriesPerPlace = 20;
constexpr double kReactionTime = 1;  // [s] to a question
/// [s] The cell has time to say something else before the person goes on.
constexpr double kTimeToRespond = 10;
constexpr int kMaxTries = 3;     // for one question
constexpr double kHoldTime = 3;  // [s] a part is kept in the hand
constexpr uint64_t kOwnChance = 0x5bd1e995;

}  // namespace

DisturbanceModel::DisturbanceModel(
    std::shared_ptr<const Demonstrations> demonstrations,
    const std::string& script, uint64_t seed, const World& world)
    : demonstrations_(std::move(demonstrations)),
      script_(&demonstrations_->scripts.at(script)),
      sampler_(std::make_shared<PlacementSampler>(
          world.table(), world.layout(),
          demonstrations_->human_motion.table_gap)),
      random_(seed ^ kOwnChance),
      // The right hand comes last in the layout.
      hand_(world.layout().hands.back().name, demonstrations_->human_motion,
            world),
      reach_(world.table(), world.layout()) {
  const Script::Disturbance& does = *script_->disturbance;
  const int count = std::uniform_int_distribution<int>(
      does.count.low, does.count.high)(random_);
  for (int i = 0; i < count; ++i) {
    times_.push_back(std::uniform_real_distribution<double>(
        does.earliest, does.latest)(random_));
  }
  std::ranges::sort(times_);
}

void DisturbanceModel::AskFor(const std::string& part,
                              const std::string& site) {
  if (script_->disturbance->helps && hand_.is_idle()) requested_ = {part, site};
}

void DisturbanceModel::AskFor(std::vector<HelpRequest> requests) {
  if (!script_->disturbance->helps) return;
  requests_ = std::move(requests);
  num_tries_left_ = requests_.empty() ? 0 : kMaxTries;
  begin_time_ = time_ + kReactionTime;
}

void DisturbanceModel::Update(double dt, World& world) {
  time_ += dt;
  if (hand_.is_idle()) {
    Begin(world);
  } else if (num_tries_left_ < kMaxTries) {
    begin_time_ = time_ + kTimeToRespond;
  }
  hand_.Update(dt, world, *sampler_, random_);
}

void DisturbanceModel::Begin(World& world) {
  if (const auto placement = std::exchange(requested_, std::nullopt)) {
    Place(*placement, world);
    return;
  }
  if (num_tries_left_ > 0 && time_ >= begin_time_) Help(world);
  if (!hand_.is_idle()) return;
  if (times_.empty() || time_ < times_.front()) return;
  has_tried_in_vain_ = !Disturb(world);
  if (has_tried_in_vain_) {
    times_.front() = time_ + kRetryAfter;
  } else {
    times_.erase(times_.begin());
  }
}

/// One thing that was asked for, the first that can be done.
void DisturbanceModel::Help(World& world) {
  --num_tries_left_;
  begin_time_ = time_ + kTimeToRespond;
  const std::vector<std::string> loose = LooseParts(world);
  for (const HelpRequest& request : requests_) {
    const auto action = ActionFor(request, *demonstrations_, loose, world);
    if (!action) continue;
    if (!action->is_removal) {
      Place({action->part, action->site}, world);
      return;
    }
    const auto X_WO = Somewhere(action->part, world);
    if (!X_WO) continue;
    hand_.PickUp(action->part, action->site);
    hand_.Place(action->part, {nullptr, "", *X_WO});
    hand_.GoToRest();
    return;
  }
}

bool DisturbanceModel::Disturb(const World& world) {
  using Kind = Script::Disturbance::Kind;
  const Kind kind = script_->disturbance->kind;
  if (kind == Kind::kPlace) return PlaceSomething(world);
  const std::vector<std::string>& types = script_->disturbance->part_types;
  std::vector<std::string> parts = LooseParts(world);
  std::erase_if(parts, [&](const std::string& part) {
    return !types.empty() &&
           std::ranges::count(types, world.table().Find(part)->type) == 0;
  });
  if (parts.empty()) return false;
  const std::string& part = parts[std::uniform_int_distribution<size_t>(
      0, parts.size() - 1)(random_)];
  const auto X_WO = Somewhere(part, world);
  if (!X_WO) return false;
  hand_.PickUp(part, "");
  if (kind == Kind::kReturn) {
    hand_.GoToRest();
    hand_.Pause(kHoldTime);
  }
  hand_.Place(part, {nullptr, "", *X_WO});
  hand_.GoToRest();
  return true;
}

/// Places a part at its site, if some can go there now. Leaves to the arms the
/// sites that they are about to fill.
bool DisturbanceModel::PlaceSomething(const World& world) {
  std::vector<std::string> taken;
  for (const ArmLayout& arm : world.layout().arms) {
    const auto held = world.hands().HeldBy(arm.gripper);
    if (!held) continue;
    const auto& fits = world.table().Find(*held)->fits;
    taken.insert(taken.end(), fits.begin(), fits.end());
  }
  if (taken.empty()) return false;
  std::vector<Placement> possible;
  const std::vector<std::string> loose = LooseParts(world);
  for (const auto& [name, rule] : demonstrations_->rules) {
    if (!IsReady(rule, *demonstrations_, world) ||
        std::ranges::find(taken, rule.site_type) != taken.end()) {
      continue;
    }
    for (const Site* site : SitesOf(world.table(), rule.site_type)) {
      if (PartAt(*site, rule, world) != nullptr) continue;
      for (const std::string& part : loose) {
        if (world.table().Find(part)->type == rule.part_type) {
          possible.push_back({part, site->name});
        }
      }
    }
  }
  if (possible.empty()) return false;
  return Place(possible[std::uniform_int_distribution<size_t>(
                   0, possible.size() - 1)(random_)],
               world);
}

bool DisturbanceModel::Place(const Placement& placement, const World& world) {
  const Part* part = world.table().Find(placement.part);
  const Site* site = world.table().FindSite(placement.site);
  if (part == nullptr || site == nullptr) return false;
  for (const auto& [name, rule] : demonstrations_->rules) {
    if (rule.part_type != part->type || rule.site_type != site->type) continue;
    hand_.PickUp(placement.part, "");
    hand_.Place(placement.part, {&rule, placement.site});
    hand_.GoToRest();
    return true;
  }
  return false;
}

/// Parts that lie about, and that no arm is at.
std::vector<std::string> DisturbanceModel::LooseParts(
    const World& world) const {
  std::vector<std::string> loose;
  for (size_t i = 0; i < world.table().parts().size(); ++i) {
    const Part& part = world.table().parts()[i];
    if (!part.is_free() || world.hands().IsHeld(static_cast<int>(i))) continue;
    const Isometry3d X_WO = world.PoseOf(part.name);
    const bool is_at_gripper =
        std::ranges::any_of(world.layout().arms, [&](const ArmLayout& arm) {
          const auto& X_WG = world.hands().StateOf(arm.gripper).X_WG;
          return (X_WG.translation() - X_WO.translation()).norm() <
                 kFromGripper;
        });
    bool is_seated = false;
    for (const auto& [name, rule] : demonstrations_->rules) {
      if (rule.part_type != part.type) continue;
      for (const Site* site : SitesOf(world.table(), rule.site_type)) {
        is_seated |= PartAt(*site, rule, world) == &part;
      }
    }
    if (!is_at_gripper && !is_seated) loose.push_back(part.name);
  }
  return loose;
}

std::vector<PlacementSampler::Placed> DisturbanceModel::SceneIn(
    const World& world) const {
  std::vector<PlacementSampler::Placed> scene;
  for (const Part& part : world.table().parts()) {
    scene.push_back({part.name, world.PoseOf(part.name)});
  }
  return scene;
}

/// One of the script's places, or anywhere on the table: where an arm can take
/// it, unless the script wants it beyond their reach.
std::optional<Isometry3d> DisturbanceModel::Somewhere(const std::string& part,
                                                      const World& world) {
  if (!script_->disturbance->places.empty()) {
    return AtOneOfThePlaces(part, world);
  }
  PlacementSampler::Accept accept;
  if (!script_->disturbance->beyond_reach) {
    accept = [&](const auto& scene) {
      return reach_.CanTake(part, scene);
    };
  }
  return sampler_->FreePlace(part, SceneIn(world), kMinMove, random_, accept);
}

/// That with the most room first, turned anyhow; nothing if no arm could take
/// the part from any.
std::optional<Isometry3d> DisturbanceModel::AtOneOfThePlaces(
    const std::string& part, const World& world) {
  auto places = script_->disturbance->places;
  std::vector<PlacementSampler::Placed> scene = SceneIn(world);
  std::erase_if(scene, [&](const auto& other) { return other.part == part; });
  const auto room = [&](const Eigen::Vector2d& place) {
    double least = 1;
    for (const auto& [name, X_WO] : scene) {
      const Vector3d p = X_WO.translation();
      least = std::min(least, (p.head<2>() - place).norm());
    }
    return least;
  };
  std::ranges::stable_sort(places, std::ranges::greater{}, room);
  std::uniform_real_distribution<double> yaw(-std::numbers::pi,
                                             std::numbers::pi);
  for (const Eigen::Vector2d& place : places) {
    for (int i = 0; i < kTriesPerPlace; ++i) {
      Isometry3d X_WO = Isometry3d::Identity();
      X_WO.linear() =
          Eigen::AngleAxisd(yaw(random_), Vector3d::UnitZ()).toRotationMatrix();
      X_WO.translation() << place, 0;
      X_WO.translation().z() = -sampler_->ExtentOf(part).Lowest(X_WO);
      if (script_->disturbance->beyond_reach) return X_WO;
      scene.push_back({part, X_WO});
      if (reach_.CanTake(part, scene)) return X_WO;
      scene.pop_back();
    }
  }
  return std::nullopt;
}

}  // namespace cell::vtb
