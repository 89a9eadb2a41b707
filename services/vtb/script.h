#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/predicates/seat.h"
#include "services/vtb/hand_path.h"

namespace cell::vtb {

/// "Parts of this type go to sites of that type."
struct PlacementRule {
  std::string name;
  /// What the person calls the action, if asked; empty: nothing.
  std::string called;
  /// The predicate of the task that is true of what is placed so, as far as the
  /// person knows what the cell means by it; empty: the person does not.
  std::string makes;
  std::string part_type;
  std::string site_type;
  std::vector<std::string> after;  ///< rules whose parts must be in place
  Eigen::Vector3d aim = Eigen::Vector3d::Zero();  ///< [m] off the site, in S
  double press = 0;      ///< [m] beyond the seat that the hand presses to
  SeatTolerance seated;  ///< a part is seated within these of its site
};

struct CountRange {
  int low = 0, high = 0;
};

/// What a scripted person does; demonstrators.yaml of a task.
struct Script {
  std::string name;
  std::string agent = "person";    ///< who is to reach the goal, or "robot"
  double max_duration = 1800;      ///< [s] the episode ends then anyway
  int num_hands = 1;               ///< of the person
  std::vector<std::string> place;  ///< rules, in any valid order
  CountRange take_backs;           ///< placed parts put back on the table ...
  std::vector<std::string> take_back_of;  ///< ... of these rules
  CountRange unknown_moves;  ///< parts moved from here to there on the table
  /// Times at which it is tried out whether some parts seat at some sites.
  CountRange attempts;
  /// Rule whose part is placed although another must come first, and then
  /// taken back.
  std::optional<std::string> too_early;
  /// Where a part is at the start, in place of standing anywhere.
  struct Start {
    std::string site;  ///< seated there; empty: it lies on its side
  };
  std::map<std::string, Start> start;  ///< by part
  /// A person beside the robot.
  struct Disturbance {
    enum class Kind {
      kMove,    ///< a part to another place
      kReturn,  ///< the same, after having kept it a while
      kPlace    ///< where it belongs
    };
    bool helps = false;  ///< does what the cell asks for
    Kind kind = Kind::kMove;
    CountRange count;                 ///< of what disturbs
    double earliest = 0, latest = 0;  ///< [s] in the episode
    /// Types of the parts that are moved; none: any.
    std::vector<std::string> part_types;
    /// [m] in the plane of W, where moved parts go; none: anywhere free.
    std::vector<Eigen::Vector2d> places;
    /// Moved parts may go where no arm can take them; else they never do.
    bool beyond_reach = false;
  };
  std::optional<Disturbance> disturbance;
  /// Part types of which one is laid down outside the workspace, at the end.
  std::vector<std::string> lay_outside;
  /// Part types of which one is laid down in the parts area; that is all.
  std::vector<std::string> lay_down;
};

/// How persons move. Ranges are sampled evenly.
struct HumanMotionParams {
  HandPath::Speeds speeds;
  double speed_spread = 0;  ///< factor 1 -+ spread per person and movement
  double bend = 0;          ///< [m] sideways, at most
  double first_pause = 0;   ///< [s]
  double pause_low = 0, pause_high = 0;  ///< [s] between actions
  double dwell = 0;         ///< [s] still after gripping and before opening
  double close_time = 0;    ///< [s] of the fingers
  double open_margin = 0;   ///< [m] each finger, beyond the part
  double insert_speed = 0;  ///< [m/s] mean, along the way in
  double aim_error = 0;     ///< [m] per axis, at most
  double turn_rate = 0;     ///< [rad/s] of the fingertips' roll
  double clearance = 0;     ///< [m] above what is passed over
  double table_gap = 0;     ///< [m] between parts on the table
  double hands_gap = 0;     ///< [m] between the ways of two hands
};

struct Demonstrations {
  std::string goal;  ///< of the task's domain, that the persons work for
  /// Scripts of a run that names none, an episode each.
  std::vector<std::string> default_episodes;
  HumanMotionParams human_motion;
  /// Scripts that show a cell all its actions, one demonstration each.
  std::vector<std::string> teaching;
  /// Scripts by what is to be said of them: the person does it `correct`ly,
  /// with a `deviation` that makes the way to the goal longer, into a
  /// `dead_end`.
  std::map<std::string, std::vector<std::string>> watched;
  /// What the person calls the action that laying a part down undoes; empty:
  /// nothing.
  std::string raising;
  /// The predicate of the task that is true of a part that lies, as far as the
  /// person knows what the cell means by it; empty: the person does not.
  std::string lies;
  std::map<std::string, PlacementRule> rules;
  std::map<std::string, Script> scripts;

  /// @throws ConfigError naming file:key; rules that wait for each other are
  /// refused, and so are types that no part or site has.
  static Demonstrations FromConfig(const Config& config,
                                   const PartTable& table);
};

}  // namespace cell::vtb
