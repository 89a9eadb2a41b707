#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <utility>

#include "common/bus/lcm_port.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/node/run_service.h"
#include "common/text/printable_output.h"
#include "common/text/terminal.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/cell_address.h"
#include "services/cell/running/progress.h"
#include "services/cell/running/traffic.h"
#include "services/cell/running/traffic_table.h"

namespace cell::cli {
namespace {

/// [s] A service reports its processor time every second; a share needs two.
constexpr double kMaxHealthS = 2.5;

struct TopOptions {
  CellAddress address;
  std::string deploy_dir;
  double period_s = 1;
  int num_reports = 0;
};

int RunTop(const TopOptions& options) {
  const LcmAddress address = options.address.Reach();
  const Progress clock;
  Traffic traffic(FindCellFiles(options.deploy_dir).roster.NumListed());
  LcmPort main(address.MainUrl());
  LcmPort control(address.ControlUrl());
  main.Subscribe(".*", [&](const std::string& channel, Bytes bytes) {
    traffic.OnMessage(channel, std::move(bytes));
  });
  control.Subscribe(
      kHealthChannel, [&](const std::string& channel, Bytes bytes) {
        traffic.OnControl(channel, std::move(bytes), clock.ElapsedSeconds());
      });
  const auto& stop = StopOnSignals();
  const bool is_redrawn = TakesTerminalCodes(STDOUT_FILENO);
  double begin = 0;
  for (int i = 0;
       !stop && (options.num_reports == 0 || i < options.num_reports); ++i) {
    const double end = begin + options.period_s;
    const auto is_due = [&] {
      const double since_s = clock.ElapsedSeconds() - end;
      return since_s >= (traffic.KnowsProcessorTimes() ? 0 : kMaxHealthS);
    };
    while (!stop && !is_due()) {
      const double left_s = std::max(end - clock.ElapsedSeconds(), 0.01);
      constexpr double kMaxWaitMs = 50;
      WaitForAny(
          {&main, &control},
          static_cast<int>(std::ceil(std::min(1e3 * left_s, kMaxWaitMs))));
      main.Drain();
      control.Drain();
    }
    const double now = clock.ElapsedSeconds();
    if (is_redrawn) WriteTerminalCode(std::cout, "\x1b[H\x1b[2J");
    std::cout << TrafficTable(traffic.MakeReport(now - begin),
                              TerminalColumns(STDOUT_FILENO))
              << std::flush;
    begin = now;
  }
  return 0;
}

}  // namespace

void AddTop(CLI::App& app, Action* action) {
  auto options = std::make_shared<TopOptions>();
  CLI::App* command = app.add_subcommand(
      "top",
      "Watch a running cell: each service's processor time, memory and "
      "losses, each channel's rate, bytes, gaps and rejected messages.\n"
      "Example: cell top --period 2 --reports 1");
  options->address.AddTo(*command);
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--period", options->period_s, "[s] between reports")
      ->check(NumberIn(0.1, 60.))
      ->capture_default_str();
  command
      ->add_option("--reports", options->num_reports,
                   "stop after this many; 0: run until Ctrl-C")
      ->check(NumberIn(0));
  command->callback([=] {
    *action = [=] {
      return RunTop(*options);
    };
  });
}

}  // namespace cell::cli
