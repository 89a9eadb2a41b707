#pragma once

#include <Eigen/Core>

#include "services/robot_arm/contact/contact_motion.h"
#include "services/robot_arm/contact/contact_stage.h"
#include "services/robot_arm/contact/seated_termination.h"
#include "services/robot_arm/contact/straight_feed.h"

namespace cell::robot_arm {

/// How a part is inserted at a site of some type. Stalls, searches and dither
/// are those of ContactMotion.
struct InsertionParams {
  StraightFeed::Params feed;
  ContactMotion::Params contact;
  SeatedTermination::Params seat;
  Eigen::Vector2d aim = Eigen::Vector2d::Zero();  ///< [m] in S, beside it
};

/// Brings a held part along the axis of a site to its seat: its frame O is to
/// reach S along -z. Begins `height` [m] above it.
ContactMotion MakeInsertion(const InsertionParams& params, double height);

/// The same, for a stage.
ContactMotionMaker InsertionMaker(const InsertionParams& params);

}  // namespace cell::robot_arm
