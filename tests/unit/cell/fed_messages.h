#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "cell/truth_poses_t.hpp"
#include "common/bus/bus.h"
#include "common/geometry/pose.h"
#include "tests/unit/stage_testing.h"

namespace cell {

/// The message as a log has it. @param utime  [us] of its header
template <class M>
Message LoggedMessage(const std::string& channel, M message, int64_t utime) {
  message.header.utime = utime;
  return {channel, 0, 0, 0, 0, std::make_shared<Bytes>(Bus::Encode(message))};
}

/// The parts where the stage has them.
inline truth_poses_t TruthOf(const Stage& stage, const PartTable& parts) {
  truth_poses_t truth{};
  for (const Part& part : parts.parts()) {
    truth.bodies.push_back({part.name, PoseToMessage(stage.PoseOf(part.name))});
  }
  truth.num_bodies = static_cast<int32_t>(truth.bodies.size());
  return truth;
}

}  // namespace cell
