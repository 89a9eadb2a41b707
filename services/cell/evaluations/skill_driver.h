#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "cell/skill_result_t.hpp"
#include "common/bus/bus.h"
#include "common/skills/skill_arguments.h"

namespace cell::cli {

/// Stands in for planner and supervisor where single skills are tried: lets the
/// arms move and requests one skill after the other, then reports that the task
/// is done.
class SkillDriver final : public Service {
 public:
  struct Task {
    std::string arm;
    std::string skill;
    SkillArguments arguments;
  };
  struct Params {
    std::deque<Task> tasks;
    /// What an arm refuses to insert, this arm presents once; empty: none does.
    std::string helper;
  };

  /// `bus` must outlive this object.
  SkillDriver(Bus& bus, const Params& params);

 private:
  void OnResult(const skill_result_t& result);
  void OnTick();
  void Ask(const Task& task);

  Bus& bus_;
  Params params_;
  Task requested_;  // the last
  bool is_waiting_ = false, has_helped_ = false, is_done_ = false;
  int64_t id_ = 0;
};

}  // namespace cell::cli
