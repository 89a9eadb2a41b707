#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cell/arm_report_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/skills/skill_arguments.h"
#include "tests/sim/assembling_cell.h"

namespace cell {

/// Checks in every run that nothing is executed twice, and that nothing is
/// begun without permission.
class SkillWatch {
 public:
  explicit SkillWatch(AssemblingCell& cell) : cell_(cell) {
    cell.On<motion_permit_t>("MOTION_PERMIT", [this](const auto& permit) {
      before_ = std::exchange(permit_, permit);
    });
    cell.On<asked_skill_t>("SKILL_REQUEST",
                           [this](const auto& m) { OnRequest(m); });
    cell.On<skill_result_t>("SKILL_RESULT",
                            [this](const auto& m) { OnResult(m); });
    for (const char* arm : {"LEFT", "RIGHT"}) {
      cell.On<arm_report_t>(std::string("ARM_REPORT_") + arm,
                            [this](const auto& m) { OnReport(m); });
    }
    cell.On<execution_t>("EXECUTION", [this](const auto& m) {
      last_execution_ = m;
      if (kIsVerbose && m.state == execution_t::STUCK) Log("asks: " + m.text);
    });
  }

  bool is_done() const {
    return last_execution_ && last_execution_->state == execution_t::DONE;
  }
  /// Of the robot's last EXECUTION: what it asks.
  std::string question() const {
    return last_execution_ ? last_execution_->text : "it never began";
  }
  const std::vector<skill_result_t>& results() const { return results_; }
  const std::map<int64_t, asked_skill_t>& requests() const { return requests_; }
  int NumOf(int8_t outcome) const {
    int num = 0;
    for (const skill_result_t& result : results_)
      num += result.outcome == outcome;
    return num;
  }

 private:
  const bool kIsVerbose = std::getenv("CELL_VERBOSE") != nullptr;

  void OnRequest(const asked_skill_t& request) {
    EXPECT_TRUE(requests_.emplace(request.id, request).second)
        << "request " << request.id << " is made twice";
    if (request.skill == "insert") {
      const std::string part = ArgumentOf(request, "part");
      EXPECT_FALSE(inserted_.contains(part))
          << part << " is inserted again, at tick " << request.header.tick;
    }
    if (kIsVerbose) {
      Log("asked: " + std::to_string(request.id) + " " + request.arm + " " +
          request.skill + " " + ArgumentOf(request, "part") + " " +
          ArgumentOf(request, "site"));
    }
  }

  void OnResult(const skill_result_t& result) {
    results_.push_back(result);
    const auto request = requests_.find(result.id);
    ASSERT_TRUE(request != requests_.end());
    if (result.outcome == skill_result_t::SUCCEEDED &&
        request->second.skill == "insert") {
      inserted_.insert(ArgumentOf(request->second, "part"));
    }
    if (kIsVerbose) {
      Log("ended: " + std::to_string(result.id) + " outcome " +
          std::to_string(result.outcome) + " " + result.reason);
    }
  }

  void OnReport(const arm_report_t& report) {
    int64_t& running = running_.try_emplace(report.arm, -1).first->second;
    std::string& phase = phases_[report.arm];
    if (kIsVerbose && phase != report.phase) {
      Log(report.arm + ": " + report.phase + ", holds '" + report.held + "'");
    }
    phase = report.phase;
    if (report.request == running) return;
    running = report.request;
    if (running == -1) return;
    EXPECT_TRUE(begun_.insert(running).second)
        << "request " << running << " is executed twice";
    // The service acts on the permit of the tick before its report.
    const auto& permit = permit_ && permit_->header.tick < report.header.tick
                             ? permit_
                             : before_;
    ASSERT_TRUE(permit.has_value());
    EXPECT_EQ(permit->hold, motion_permit_t::NONE)
        << "request " << running << " is begun while the cell holds";
    EXPECT_EQ(permit->mode, motion_permit_t::EXECUTE);
  }

  void Log(const std::string& text) const {
    std::cerr << cell_.tick() << ": " << text << "\n";
  }

  AssemblingCell& cell_;
  std::optional<motion_permit_t> permit_, before_;
  std::map<int64_t, asked_skill_t> requests_;
  std::vector<skill_result_t> results_;
  std::map<std::string, int64_t> running_;     // by arm
  std::map<std::string, std::string> phases_;  // by arm
  std::set<int64_t> begun_;
  std::set<std::string> inserted_;
  std::optional<execution_t> last_execution_;
};

}  // namespace cell
