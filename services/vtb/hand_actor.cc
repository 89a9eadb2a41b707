#include "services/vtb/hand_actor.h"

#include <utility>

#include "services/vtb/hand_actions.h"

namespace cell::vtb {

HandActor::HandActor(std::string hand, const HumanMotionParams& human_motion,
                     const World& world) {
  hand_.name = std::move(hand);
  hand_.human_motion = human_motion;
  for (const CellLayout::Hand& layout : world.layout().hands) {
    if (layout.name == hand_.name) {
      hand_.X_WG_rest.translation() = layout.p_WG_rest;
    }
  }
  hand_.X_WG = hand_.X_WG_rest;
}

void HandActor::Do(const HandAction& action) {
  stages_.insert(stages_.end(), action.begin(), action.end());
}

void HandActor::PickUp(const std::string& part, const std::string& from_site) {
  Do(hand_action::Reach(part));
  Do(hand_action::Grasp(part));
  if (!from_site.empty()) Do(hand_action::Extract(from_site));
}

void HandActor::Place(const std::string& part, const Target& target) {
  Do(hand_action::Carry(part, target));
  Do(hand_action::Insert(part, target));
  Do(hand_action::Turn(part, target));
  Do(hand_action::Release(part));
  Do(hand_action::Retreat());
}

void HandActor::GoToRest() {
  Do(hand_action::Rest());
}

void HandActor::Pause(double duration) {
  Do(hand_action::Pause(duration));
}

std::vector<Eigen::Vector2d> HandActor::WayAhead(const World& world) const {
  std::vector<Eigen::Vector2d> way{hand_.X_WG.translation().head<2>()};
  for (const auto& stage : stages_) {
    if (const auto to = stage->LeadsTo(hand_, world)) way.push_back(*to);
  }
  return way;
}

void HandActor::Update(double dt, World& world, const PlacementSampler& sampler,
                       std::mt19937_64& random) {
  if (!stages_.empty()) {
    const HandStage& stage = *stages_.front();
    const bool is_new = !run_;
    if (is_new) {
      run_ = {0, HandPath(hand_.X_WG), hand_.opening, hand_.opening};
    }
    HandContext context{hand_, *run_, world, sampler, random, dt};
    if (is_new) stage.Begin(context);
    run_->time += dt;
    const HandStage::Progress progress = stage.Act(context);
    if (progress.is_done) Finish(progress);
  }
  world.hands().Move(hand_.name, hand_.X_WG, hand_.opening);
}

void HandActor::Finish(const HandStage::Progress& progress) {
  run_.reset();
  stages_.pop_front();
  if (progress.is_all_dropped) stages_.clear();
  stages_.insert(stages_.begin(), progress.next.begin(), progress.next.end());
}

}  // namespace cell::vtb
