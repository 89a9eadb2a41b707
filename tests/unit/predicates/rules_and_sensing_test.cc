#include <gtest/gtest.h>

#include <map>
#include <random>

#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/predicates/predicate_sensor.h"
#include "tests/unit/cranfield_domain.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;

constexpr double kTouching = 2e-3;  // [m]

/// The parts where they are after some actions, and what is sensed of them.
class PlacementSampler {
 public:
  PlacementSampler() : shapes_(ShapesOf(task_.parts)) {
    const std::map<std::string, Vector2d> places = {
        {"face_plate", {-0.20, -0.50}},  {"separator", {0.12, -0.28}},
        {"pendulum", {0.45, -0.45}},     {"head", {0.10, -0.45}},
        {"round_peg_1", {0.00, -0.60}},  {"round_peg_2", {0.10, -0.60}},
        {"square_peg_1", {0.20, -0.60}}, {"square_peg_2", {0.30, -0.60}},
        {"shaft", {0.20, -0.45}}};
    for (size_t i = 0; i < task_.parts.parts().size(); ++i) {
      const auto place = places.find(task_.parts.parts()[i].name);
      if (place == places.end()) {
        X_WO_.push_back(task_.layout.pedestal.X_WP);
        continue;
      }
      const double z = -shapes_[i].LowestZ(Isometry3d::Identity());
      X_WO_.push_back(Translation3d(place->second.x(), place->second.y(), z) *
                      Isometry3d::Identity());
    }
  }

  void Seat(const std::string& part, const std::string& site_name) {
    const Site& site = *task_.parts.FindSite(site_name);
    X_WO_[Index(part)] = X_WO_[Index(site.host)] * site.X_HS;
  }

  State Sense() const {
    Scene scene;
    for (size_t i = 0; i < X_WO_.size(); ++i) {
      Scene::Item item;
      item.visibility = Visibility::kSeen;
      item.X_WO = X_WO_[i];
      for (size_t k = 0; k < X_WO_.size(); ++k) {
        item.touches.push_back(
            i != k && PartShape::Distance(shapes_[i], X_WO_[i], shapes_[k],
                                          X_WO_[k], 2 * kTouching) < kTouching);
      }
      scene.items.push_back(std::move(item));
    }
    return sensor_->Sense(scene);
  }

 private:
  size_t Index(const std::string& name) const {
    return static_cast<size_t>(task_.parts.Find(name) -
                               task_.parts.parts().data());
  }

  ShippedTask task_;
  std::vector<PartShape> shapes_;
  std::shared_ptr<const PredicateSensor> sensor_ = task_.MakeSensor();
  std::vector<Isometry3d> X_WO_;
};

class RulesAndSensing : public testing::Test {
 protected:
  /// Names of the sensed atoms that differ, with the sensed truth.
  std::string Difference(const State& sensed, const State& state) const {
    const Vocabulary& v = cranfield_.domain->vocabulary();
    std::string text;
    for (int i = 0; i < state.num_atoms(); ++i) {
      if (v.predicates()[v.Atom(i).predicate].report) continue;
      if (sensed.Get(i) == state.Get(i)) continue;
      text += cranfield_.domain->vocabulary().AtomName(i) + " is sensed as " +
              std::to_string(static_cast<int>(sensed.Get(i))) + "; ";
    }
    return text;
  }
  /// Where the action puts its first object.
  std::string SiteOf(const GroundAction& action) const {
    const auto& objects = cranfield_.domain->vocabulary().objects();
    if (action.arguments.size() == 2) return objects[action.arguments[1]].name;
    const std::string& part = objects[action.arguments[0]].name;
    return (part == "head" ? "pendulum." : "base.") + part;
  }
  void Seat(PlacementSampler& sampler, const GroundAction& action) const {
    sampler.Seat(
        cranfield_.domain->vocabulary().objects()[action.arguments[0]].name,
        SiteOf(action));
  }

  Cranfield cranfield_;
};

TEST_F(RulesAndSensing, AgreeOnEveryStateOfEveryOrder) {
  std::mt19937_64 random(7);
  for (int run = 0; run < 10; ++run) {
    PlacementSampler sampler;
    State state = cranfield_.Start();
    EXPECT_EQ(Difference(sampler.Sense(), state), "");
    for (const GroundAction& action : cranfield_.RandomOrder(random)) {
      Seat(sampler, action);
      state = cranfield_.Do(state, action);
      EXPECT_EQ(Difference(sampler.Sense(), state), "")
          << "after " << cranfield_.domain->Show(action);
    }
  }
}

/// What is placed too early comes off again, and all is as before.
TEST_F(RulesAndSensing, AgreeThatAMistakeCanBeUndone) {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"separator", "RemoveSeparator"}, {"pendulum", "RemovePendulum"}};
  PlanSearch search = cranfield_.Search();
  for (const auto& [part, remove] : mistakes) {
    PlacementSampler sampler;
    sampler.Seat(part, "base." + part);
    const State sensed = sampler.Sense();
    const State after = cranfield_.Do(sensed, remove, {part});
    EXPECT_EQ(Difference(cranfield_.Start(), after), "") << part;
    const Plan plan = search.Find(sensed);
    EXPECT_EQ(plan.result, Plan::Result::kFound) << plan.reason;
    EXPECT_NEAR(plan.expected_actions, 10 / 0.95, 1e-8) << part;
  }
}

/// It may rest on some of what belongs below it.
TEST_F(RulesAndSensing, AgreeThatACoverPlacedTooEarlyComesOff) {
  std::mt19937_64 random(8);
  PlanSearch search = cranfield_.Search();
  for (int run = 0; run < 10; ++run) {
    PlacementSampler sampler;
    State state = cranfield_.Start();
    const auto order = cranfield_.RandomOrder(random);
    for (size_t i = 0; i + 2 < order.size(); ++i) {
      Seat(sampler, order[i]);
      state = cranfield_.Do(state, order[i]);
    }
    sampler.Seat("face_plate", "base.face_plate");
    const State sensed = sampler.Sense();
    const State after =
        cranfield_.Do(sensed, "RemoveFacePlate", {"face_plate"});
    EXPECT_EQ(Difference(state, after), "")
        << "without " << cranfield_.domain->Show(order[order.size() - 2]);
    EXPECT_NEAR(search.Find(sensed).expected_actions, 3 / 0.95, 1e-8);
  }
}

}  // namespace
}  // namespace cell
