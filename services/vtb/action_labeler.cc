#include "services/vtb/action_labeler.h"

#include <algorithm>
#include <cmath>

#include "common/predicates/seat.h"

namespace cell::vtb {
namespace {

constexpr int64_t kSettleUs = 200'000;
// A part that was let go may stand a little off what the person aimed at.
constexpr double kSeatSlack = 2;
constexpr double kBesideSeat = 0.050;            // [m] lies on the site, jammed
constexpr double kMoved = 0.010;                 // [m]
constexpr double kTurned = 10 * 0.017453292519;  // [rad]

bool IsUpright(const Eigen::Isometry3d& X_WO) {
  return std::abs(X_WO.linear()(2, 2)) > std::sqrt(0.5);
}

bool IsMoved(const Eigen::Isometry3d& X_WA, const Eigen::Isometry3d& X_WB) {
  const Eigen::Isometry3d X_AB = X_WA.inverse() * X_WB;
  return X_AB.translation().norm() > kMoved ||
         Eigen::AngleAxisd(X_AB.linear()).angle() > kTurned;
}

}  // namespace

const PlacementRule* ActionLabeler::RuleOf(const Part& part,
                                           const Site& site) const {
  for (const auto& [name, rule] : demonstrations_->rules) {
    if (rule.part_type == part.type && rule.site_type == site.type) {
      return &rule;
    }
  }
  return nullptr;
}

template <class Accept>
std::optional<std::string> ActionLabeler::FindSite(const std::string& name,
                                                   const World& world,
                                                   Accept accept) const {
  const Part& part = *world.table().Find(name);
  const Eigen::Isometry3d X_WO = world.PoseOf(name);
  for (const Part& host : world.table().parts()) {
    for (const Site& site : host.sites) {
      const PlacementRule* rule = RuleOf(part, site);
      if (rule == nullptr) continue;
      const Eigen::Isometry3d X_SO =
          (world.PoseOf(host.name) * site.X_HS).inverse() * X_WO;
      if (accept(X_SO, rule->seated)) return site.name;
    }
  }
  return std::nullopt;
}

std::optional<std::string> ActionLabeler::SeatOf(const std::string& name,
                                                 const World& world) const {
  return FindSite(
      name, world,
      [](const Eigen::Isometry3d& X_SO, const SeatTolerance& seated) {
        return IsSeated(X_SO, 0,
                        {kSeatSlack * seated.z, kSeatSlack * seated.xy,
                         kSeatSlack * seated.tilt});
      });
}

bool ActionLabeler::IsBesideItsSeat(const std::string& name,
                                    const World& world) const {
  return FindSite(name, world,
                  [](const Eigen::Isometry3d& X_SO, const SeatTolerance&) {
                    return X_SO.translation().norm() < kBesideSeat;
                  })
      .has_value();
}

// True unless all that must come before this placement is in place.
bool ActionLabeler::IsTooEarly(const Part& part, const std::string& site,
                               const World& world) const {
  const PlacementRule* rule = RuleOf(part, *world.table().FindSite(site));
  for (const std::string& earlier : rule->after) {
    for (const Part& other : world.table().parts()) {
      if (other.type == demonstrations_->rules.at(earlier).part_type &&
          other.is_free() && !SeatOf(other.name, world)) {
        return true;
      }
    }
  }
  return false;
}

void ActionLabeler::NoteGrips(int64_t utime, const World& world) {
  std::map<std::string, std::string> held;
  for (const CellLayout::Hand& hand : world.layout().hands) {
    if (const auto part = world.hands().HeldBy(hand.name)) {
      held.try_emplace(*part, hand.name);
    }
  }
  for (const auto& [part, hand] : held) {
    const auto [it, is_new] = grips_.try_emplace(part);
    it->second.release_utime.reset();
    if (!is_new) continue;
    it->second.hand = hand;
    it->second.pick_utime = utime;
    it->second.from_site = SeatOf(part, world);
    it->second.X_WO_pick = world.PoseOf(part);
  }
  for (auto& [part, grip] : grips_) {
    if (!held.contains(part) && !grip.release_utime) grip.release_utime = utime;
  }
}

std::vector<LabeledAction> ActionLabeler::Update(int64_t utime,
                                                 const World& world) {
  NoteGrips(utime, world);
  std::vector<LabeledAction> done;
  for (auto it = grips_.begin(); it != grips_.end();) {
    const auto& release = it->second.release_utime;
    if (!release || utime < *release + kSettleUs) {
      ++it;
      continue;
    }
    const auto actions = Conclude(it->first, it->second, world);
    done.insert(done.end(), actions.begin(), actions.end());
    it = grips_.erase(it);
  }
  return done;
}

std::vector<LabeledAction> ActionLabeler::Conclude(const std::string& name,
                                                   const Grip& grip,
                                                   const World& world) const {
  const Eigen::Isometry3d X_WO = world.PoseOf(name);
  const auto to_site = SeatOf(name, world);
  if (to_site == grip.from_site &&
      (to_site || !IsMoved(grip.X_WO_pick, X_WO))) {
    return {};
  }
  LabeledAction action{.part = name,
                       .hand = grip.hand,
                       .pick_utime = grip.pick_utime,
                       .place_utime = *grip.release_utime};
  if (!world.layout().workspace.contains(X_WO.translation())) {
    action.mistake = LabeledAction::Mistake::kOutOfWorkspace;
  }
  std::vector<LabeledAction> actions;
  if (grip.from_site) {
    action.kind = LabeledAction::Kind::kTakenBack;
    action.site = *grip.from_site;
    actions.push_back(action);
  }
  if (to_site) {
    action.kind = LabeledAction::Kind::kPlaced;
    action.site = *to_site;
    if (IsTooEarly(*world.table().Find(name), *to_site, world)) {
      action.mistake = LabeledAction::Mistake::kOutOfOrder;
    }
    actions.push_back(action);
  }
  if (actions.empty()) {
    const bool is_tipped = IsUpright(X_WO) != IsUpright(grip.X_WO_pick);
    if (is_tipped) action.kind = LabeledAction::Kind::kTipped;
    if (IsBesideItsSeat(name, world)) {
      action.mistake = LabeledAction::Mistake::kNotSeated;
    }
    actions.push_back(action);
  }
  return actions;
}

}  // namespace cell::vtb
