// The world of the benchmark, and its assembly, for tests of the physics.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "services/vtb/world.h"

namespace cell {

inline vtb::World MakeWorld(const vtb::PhysicsParams& params = {}) {
  const std::string task = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";
  return vtb::World(PartTable::FromConfig(Config::Load(task + "parts.yaml")),
                    CellLayout::FromConfig(Config::Load(task + "cell.yaml")),
                    params);
}

inline Eigen::Isometry3d Upright(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

inline void Seat(vtb::World& world, const std::string& part,
                 const std::string& site_name) {
  const Site& site = *world.table().FindSite(site_name);
  world.Place(part, world.PoseOf(site.host) * site.X_HS);
}

inline void SeatAll(vtb::World& world) {
  for (const auto& [part, site] :
       std::vector<std::pair<std::string, std::string>>{
           {"round_peg_1", "base.round_1"},
           {"round_peg_2", "base.round_2"},
           {"square_peg_1", "base.square_1"},
           {"square_peg_2", "base.square_2"},
           {"shaft", "base.shaft"},
           {"separator", "base.separator"},
           {"pendulum", "base.pendulum"},
           {"head", "pendulum.head"},
           {"face_plate", "base.face_plate"}}) {
    Seat(world, part, site);
  }
}

}  // namespace cell
