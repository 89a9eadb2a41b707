#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "cell/health_t.hpp"
#include "common/bus/lcm_port.h"
#include "common/bus/private_network.h"
#include "common/node/cell_files.h"
#include "services/cell/running/process_group.h"
#include "tests/system/run_cell.h"

namespace cell {

using namespace cli;

/// A live cell on a network of the test's own.
class LiveCell : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    EnterPrivateNetwork();
    main_ = std::make_unique<LcmPort>(LcmAddress{}.MainUrl());
    control_ = std::make_unique<LcmPort>(LcmAddress{}.ControlUrl());
    control_->Subscribe("HEALTH", [this](const std::string&, Bytes bytes) {
      health_t health{};
      const int size = static_cast<int>(bytes.size());
      if (health.decode(bytes.data(), 0, size) == size) {
        health_[health.service] = health;
      }
    });
  }

  std::filesystem::path Run() const { return dir_ / "runs/current"; }

  /// Starts all services; returns when each is alive.
  void Start(const std::string& demonstration) {
    ASSERT_EQ(
        Cell("prepare --state-dir . --seed 7 --demonstration " + demonstration)
            .code,
        0);
    const Roster roster = FindCellFiles((Run() / "deploy").string()).roster;
    // The recorder first, the testbed last.
    for (const auto& entry : roster.entries) names_.push_back(entry.name);
    std::iter_swap(std::find(names_.begin(), names_.end(), "recorder"),
                   names_.begin());
    std::iter_swap(std::find(names_.begin(), names_.end(), "vtb"),
                   names_.end() - 1);
    for (const std::string& name : names_) StartOne(name, demonstration);
  }

  /// Listens until `is_done`, at most so long.
  bool Await(const std::function<bool()>& is_done, int timeout_ms) {
    constexpr int kStepMs = 10;
    const auto until = std::chrono::steady_clock::now() +
                       std::chrono::milliseconds(timeout_ms);
    while (std::chrono::steady_clock::now() < until) {
      WaitForAny({main_.get(), control_.get()}, kStepMs);
      main_->Drain();
      control_->Drain();
      if (is_done()) return true;
    }
    return false;
  }

  void Stop() {
    constexpr int kStopMs = 60'000;
    for (const char* name : {"vtb", "recorder"}) {
      processes_.Kill(name, SIGTERM);
      EXPECT_TRUE(Await(
          [&] {
            processes_.TakeDeaths();
            return !processes_.IsRunning(name);
          },
          kStopMs));
    }
    processes_.StopAll(kStopMs);
  }

  std::unique_ptr<LcmPort> main_;
  std::unique_ptr<LcmPort> control_;
  ProcessGroup processes_;
  std::vector<std::string> names_;
  std::map<std::string, health_t> health_;

 private:
  void StartOne(const std::string& name, const std::string& demonstration) {
    const auto [program, instance] = ServiceName::Parse(name);
    std::vector<std::string> arguments = {"--live",
                                          "--state-dir",
                                          dir_.string(),
                                          "--deploy",
                                          (Run() / "deploy").string(),
                                          "--run-dir",
                                          Run().string()};
    if (!instance.empty()) {
      arguments.insert(arguments.end(), {"--instance", instance});
    }
    if (name == "vtb") {
      arguments.insert(arguments.end(),
                       {"--demonstration", demonstration, "--seed", "7"});
    }
    processes_.Start(name, std::filesystem::path(CELL_BIN_DIR) / program,
                     arguments, dir_ / (name + ".out"));
    constexpr int kStartMs = 60'000;
    ASSERT_TRUE(Await([&] { return health_.contains(name); }, kStartMs))
        << name << ": " << TextOf(dir_ / (name + ".out"));
  }
};

}  // namespace cell
