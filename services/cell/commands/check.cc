#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/run_log.h"
#include "common/task/task.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/scoring/motion_check.h"

namespace cell::cli {
namespace {

int RunCheck(const std::string& path) {
  const RunFolder run = RunFolder::Open(path);
  const Task task = LoadTask(run.deployment);
  MotionCheck check(task.layout, task.parts);
  const RunLog log = RunLog::Load(run.path);
  for (const std::string& problem : log.problems()) {
    std::cerr << Printable(problem) << "\n";
  }
  for (const auto& [tick, entry] : log.ticks()) {
    std::vector<Message> messages = entry.messages;
    std::ranges::stable_partition(messages, [](const Message& message) {
      return message.sender == 0;  // the clock's come first
    });
    for (const Message& message : messages) check.Put(message);
  }
  for (const Violation& violation : check.violations()) {
    std::cout << fmt::format("{:9.3f} s  {:5}  {:9}  {}\n",
                             1e-6 * kTickUs * violation.tick,
                             Printable(violation.arm), NameOf(violation.kind),
                             Printable(violation.what));
  }
  std::cout << fmt::format(
      "{}, {} in {}\n",
      Counted(static_cast<int64_t>(check.violations().size()), "violation"),
      Counted(check.num_protective_stops(), "protective stop"),
      Counted(static_cast<int64_t>(log.ticks().size()), "tick"));
  const std::vector<std::string> gaps = check.Gaps();
  for (const std::string& gap : gaps) {
    std::cerr << "not checked: " << Printable(gap) << "\n";
  }
  return check.violations().empty() && gaps.empty() ? 0 : 1;
}

}  // namespace

void AddCheck(CLI::App& app, Action* action) {
  auto run = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("check",
                         "Check whether the arms of a recorded run stayed "
                         "within their limits and hit nothing.\n"
                         "Example: cell check runs/sim-0001");
  command->add_option("run", *run, "run folder")->required();
  command->callback([=] {
    *action = [=] {
      return RunCheck(*run);
    };
  });
}

}  // namespace cell::cli
