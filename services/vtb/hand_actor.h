#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/hand_path.h"
#include "services/vtb/script.h"
#include "services/vtb/tabletop.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// Where a part is to go: a site, or a pose on the table.
struct Target {
  const PlacementRule* rule = nullptr;  ///< null: the table
  std::string site;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< of the table's
  /// [rad] to tip it on the table, about the axis between the fingers; then it
  /// is let go as low as it can be and falls.
  double tilt = 0;
};

/// One hand of a person at work: takes parts and puts them down, watching what
/// it does. A value: a copy goes on in the same way.
class HandActor {
 public:
  HandActor(std::string hand, const Manner& manner, const World& world);

  /// Orders, done one after the other.
  void Take(const std::string& part, const std::string& from_site);
  void Put(const std::string& part, const Target& target);
  void GoToRest();
  void Pause(double duration);

  /// One tick: moves the hand of `world` for the coming `dt`.
  void Update(double dt, World& world, const Tabletop& tabletop,
              std::mt19937_64& random);

  bool is_idle() const { return steps_.empty(); }
  const std::string& hand() const { return hand_; }
  const Eigen::Isometry3d& X_WG() const { return X_WG_; }
  /// Parts that did not seat in spite of all tries.
  const std::vector<std::string>& failures() const { return failures_; }
  /// Where in the plane the orders still lead it, from where it is.
  std::vector<Eigen::Vector2d> WayAhead(const World& world) const;

 private:
  enum class Step {
    kPause,    // duration
    kReach,    // over the part, down to the grasp
    kClose,    // fingers
    kExtract,  // out of its site
    kCarry,    // over everything, to the approach of the target
    kLower,    // along the way in, and press
    kSettle,   // until it is seated: search by small circles
    kRaise,    // for another try
    kTurn,     // until a thread is turned home
    kRelax,    // no force before letting go
    kOpen,     // fingers
    kRetreat,  // back along the way in
    kRest      // to its place
  };
  struct Order {
    Step step;
    std::string part;
    std::string site;  // kExtract: where it is
    Target target;
    double duration = 0;
  };

  void Begin(World& world, const Tabletop& tabletop, std::mt19937_64& random);
  bool Act(World& world);  // true if the step is done
  void PlanReach(const Order& order, World& world, const Tabletop& tabletop,
                 std::mt19937_64& random);
  void PlanCarry(const Order& order, World& world, const Tabletop& tabletop,
                 std::mt19937_64& random);
  HandPath WayOver(const Eigen::Isometry3d& X_WG, const World& world,
                   const Tabletop& tabletop, std::mt19937_64& random);
  Eigen::Isometry3d GoalOf(const Order& order, const World& world) const;
  Eigen::Vector3d WayOut(const std::string& site, const World& world) const;
  bool IsSeated(const Order& order, const World& world) const;
  bool Settle(const Order& order, World& world);
  bool Turn(const Order& order, World& world);
  void TryAgain(const Order& order);
  double Spread(std::mt19937_64& random) const;

  std::string hand_;
  Manner manner_;
  std::deque<Order> steps_;
  bool has_begun_ = false;
  double time_ = 0;  // in the step
  Eigen::Isometry3d X_WG_, X_WG_rest_;
  double opening_ = 0, opening_from_ = 0, opening_to_ = 0;
  HandPath path_;
  double grasp_width_ = 0;
  Eigen::Isometry3d X_GO_ = Eigen::Isometry3d::Identity();  // of the held part
  Eigen::Matrix3d symmetry_ = Eigen::Matrix3d::Identity();  // chosen for carry
  Eigen::Vector3d aim_error_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d way_out_ = Eigen::Vector3d::UnitZ();  // of the last target
  double retreat_ = 0;
  double roll_ = 0;
  Eigen::Isometry3d X_WO_table_ = Eigen::Isometry3d::Identity();
  double dt_ = 0;
  int tries_ = 0;
  std::vector<std::string> failures_;
};

}  // namespace cell::vtb
