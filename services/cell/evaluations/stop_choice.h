#pragma once

#include <cstdint>
#include <string>

namespace cell::cli {

/// By what an arm is stopped.
enum class StopKind { kProtective, kHold, kDeath };
const char* NameOf(StopKind kind);

/// When and how a skill is to be stopped.
struct StopChoice {
  std::string stage;  ///< as ARM_REPORT names the phase, or its beginning
  int32_t delay = 0;  ///< [ticks] from its beginning
  StopKind kind = StopKind::kProtective;
  int32_t duration = 0;  ///< [ticks] until the operator resumes or it restarts
};

enum class StoppedSkill { kInsert, kInsertTurning, kSetDown };

/// Every stage of a skill by every kind of stop in turn, so that few runs have
/// seen all. `seed` of the run, `index` of the skill in it among its kind.
StopChoice ChooseStop(StoppedSkill skill, uint64_t seed, int index);

}  // namespace cell::cli
