#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/bus/lcm_port.h"
#include "common/bus/private_network.h"
#include "common/config/decimal.h"
#include "common/node/cell_files.h"
#include "common/node/run_service.h"
#include "services/cell/commands/commands.h"
#include "services/cell/reporting/run_report.h"
#include "services/cell/running/demo_registry.h"
#include "services/cell/running/process_group.h"
#include "services/cell/running/process_output.h"
#include "services/cell/running/restart_policy.h"
#include "services/cell/running/run_options.h"

namespace cell::cli {
namespace {

struct DemoOptions {
  RunOptions run;
  std::string pace = "fast";
  std::vector<std::string> kills;
};

struct PlannedKill {
  std::string service;
  int32_t tick = 0;
};

PlannedKill ParseKill(const std::string& text, const Roster& roster) {
  const size_t at = text.rfind('@');  // names may have one, too
  if (at != std::string::npos) {
    PlannedKill kill{text.substr(0, at), 0};
    const auto tick = ParseDecimal<int>(text.substr(at + 1));
    if (tick && *tick >= 0 && roster.IndexOf(kill.service).value_or(0) > 0) {
      kill.tick = *tick;
      return kill;
    }
  }
  throw std::invalid_argument(
      "--kill " + text +
      ": should be SERVICE@TICK with a service of roster.yaml other than the "
      "clock and a decimal number");
}

// All processes of a cell on a network of their own, until the clock ends.
class Demo {
 public:
  Demo(const DemoOptions& options, const RunFolder& run)
      : options_(options), run_(run), report_(run, options.run) {
    for (const std::string& text : options.kills) {
      kills_.push_back(ParseKill(text, run.roster));
    }
  }

  int Run(const std::atomic<bool>& stop) {
    for (const Roster::Entry& entry : run_.roster.entries) Start(entry.name);
    std::optional<LcmPort> ticks;
    std::vector<LcmPort*> ports;
    if (!kills_.empty()) {
      ticks.emplace(LcmAddress{}.MainUrl());
      ports.push_back(&*ticks);
      ticks->Subscribe("TICK", [this](const std::string&, Bytes bytes) {
        if (bytes.size() >= kWireHeaderEnd) {
          KillDue(ReadWireHeader(bytes).tick);
        }
      });
    }
    constexpr int kLookMs = 20;
    while (IsRunning()) {
      if (stop) {
        processes_.StopAll(kGraceMs);
        run_.Stopped();
      }
      WaitForAny(ports, kLookMs);
      if (ticks) ticks->Drain();
      report_.Follow();
      ForwardOutputs();
      for (const auto& death : processes_.TakeDeaths()) {
        // After the last tick all end, the clock among the last.
        death.is_clean&& death.name != clock() ? ended_.push_back(death)
                                               : OnDeath(death);
      }
      // A service that has ended although the clock goes on was stopped.
      num_looks_since_end_ = ended_.empty() ? 0 : num_looks_since_end_ + 1;
      if (num_looks_since_end_ * kLookMs > kGraceMs) {
        for (const auto& death : std::exchange(ended_, {})) OnDeath(death);
      }
      resident_bytes_ = std::max(resident_bytes_, processes_.ResidentBytes());
    }
    AwaitOthers();
    ForwardOutputs();
    const int result = report_.Finish();
    report_.Print(fmt::format("resident memory of all services: {} MB",
                              resident_bytes_ >> 20));
    return is_failed_ ? 1 : result;
  }

 private:
  static constexpr int kGraceMs = 3000;

  const std::string& clock() const { return run_.roster.entries[0].name; }
  bool IsRunning() const { return processes_.IsRunning(clock()); }

  void Start(const std::string& name) {
    std::vector<std::string> arguments = {"--deploy",
                                          (run_.path / "deploy").string(),
                                          "--run-dir", run_.path.string()};
    if (name == clock()) {
      arguments.insert(arguments.end(), {"--seed", std::to_string(run_.seed),
                                         "--pace", options_.pace});
      if (!run_.demonstration.empty()) {
        arguments.insert(arguments.end(),
                         {"--demonstration", run_.demonstration});
      }
    }
    const auto [program, instance] = ServiceName::Parse(name);
    if (!instance.empty()) {
      arguments.insert(arguments.end(), {"--instance", instance});
    }
    const int output = outputs_.Open(name, LogOf(name));
    processes_.Start(name, FolderOfPrograms() / program, arguments, output);
    close(output);
  }

  std::filesystem::path LogOf(const std::string& name) const {
    return run_.path / (name + ".out");
  }

  void KillDue(int32_t tick) {
    for (PlannedKill& kill : kills_) {
      if (kill.tick > tick || kill.tick < 0) continue;
      kill.tick = -1;
      processes_.Kill(kill.service, SIGKILL);
    }
  }

  void OnDeath(const ProcessGroup::Death& death) {
    ForwardOutputs();  // with its reason
    const std::string where = " (see " + LogOf(death.name).string() + ")";
    if (death.name == clock()) {
      if (death.is_clean) return;
      is_failed_ = true;
      report_.Print(death.name + ": " + death.cause + ", the run ends" + where);
      return;
    }
    if (const auto why =
            restarts_.WhyNot(death, outputs_.LastLineOf(death.name))) {
      throw std::runtime_error(death.name + ": " + death.cause +
                               "; the run ends, because " + *why);
    }
    report_.Print(death.name + ": " + death.cause + ", restarted" + where);
    Start(death.name);
  }

  // The user sees the output of the processes, too.
  void ForwardOutputs() {
    for (const std::string& line : outputs_.TakeLines()) report_.Print(line);
  }

  // The others end by themselves after the last tick.
  void AwaitOthers() {
    constexpr int kStepMs = 10;
    for (int waited = 0; waited < kGraceMs; waited += kStepMs) {
      processes_.TakeDeaths();
      bool is_any = false;
      for (const Roster::Entry& entry : run_.roster.entries) {
        is_any |= processes_.IsRunning(entry.name);
      }
      if (!is_any) return;
      WaitForAny({}, kStepMs);
    }
    processes_.StopAll(0);
  }

  const DemoOptions& options_;
  const RunFolder& run_;
  RunReport report_;
  ProcessGroup processes_;
  ProcessOutput outputs_;
  std::vector<PlannedKill> kills_;
  RestartPolicy restarts_;
  std::vector<ProcessGroup::Death> ended_;
  int num_looks_since_end_ = 0;
  int64_t resident_bytes_ = 0;
  bool is_failed_ = false;
};

int RunDemo(const DemoOptions& options) {
  const RunFolder run = options.run.CreateFolder("demo");
  const DemoRegistration registration(run.path);
  EnterPrivateNetwork();
  return Demo(options, run).Run(StopOnSignals());
}

}  // namespace

void AddDemo(CLI::App& app, Action* action) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command = app.add_subcommand(
      "demo",
      "Run the cell with each service as a process, over LCM on a private "
      "network: it watches a person assemble, or assembles with its arms "
      "(--demonstration execution; assembly+execution runs one after the "
      "other), or learns to by asking (--from-nothing).\n"
      "Example: cell demo --seed 7 --pace realtime");
  options->run.AddTo(*command);
  command
      ->add_option("--pace", options->pace,
                   "as fast as the machine allows, or realtime")
      ->check(CLI::IsMember({"fast", "realtime"}))
      ->capture_default_str();
  command->add_option("--kill", options->kills,
                      "SERVICE@TICK: kill -9 it there (may be repeated)");
  command->callback([=] {
    *action = [=] {
      return RunDemo(*options);
    };
  });
}

}  // namespace cell::cli
