#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/bus/run_log.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"

namespace cell::cli {
namespace {

// The first thing in which two ticks differ, or nothing.
std::optional<std::string> Difference(const RunLog::Tick& a,
                                      const RunLog::Tick& b) {
  const size_t num = std::max(a.messages.size(), b.messages.size());
  for (size_t i = 0; i < num; ++i) {
    const bool in_a = i < a.messages.size();
    const bool in_b = i < b.messages.size();
    const auto differ = [&] {
      return OrderedBefore(a.messages[i], b.messages[i]) ||
             OrderedBefore(b.messages[i], a.messages[i]);
    };
    if (!in_a || !in_b || differ()) {
      const bool is_of_a =
          in_a && (!in_b || OrderedBefore(a.messages[i], b.messages[i]));
      const Message& odd = is_of_a ? a.messages[i] : b.messages[i];
      return fmt::format("{} sender {} seq {} only in the {} run", odd.channel,
                         odd.sender, odd.seq, is_of_a ? "first" : "second");
    }
    if (*a.messages[i].bytes != *b.messages[i].bytes) {
      return fmt::format("{} sender {} seq {} differs", a.messages[i].channel,
                         a.messages[i].sender, a.messages[i].seq);
    }
  }
  return std::nullopt;
}

bool IsWhole(const std::string& path, const RunLog& run) {
  for (const std::string& problem : run.problems()) {
    std::cerr << path << ": " << problem << "\n";
  }
  return run.problems().empty();
}

int RunDiff(const std::string& first, const std::string& second) {
  const RunLog a = RunLog::Load(first);
  const RunLog b = RunLog::Load(second);
  const bool is_a_whole = IsWhole(first, a);
  const bool is_b_whole = IsWhole(second, b);
  for (const auto& [tick, in_a] : a.ticks()) {
    const auto in_b = b.ticks().find(tick);
    if (in_b == b.ticks().end()) {
      std::cout << fmt::format("the second run has no tick {}\n", tick);
      return 1;
    }
    if (const auto difference = Difference(in_a, in_b->second)) {
      std::cout << fmt::format("tick {}: {}\n", tick, Printable(*difference));
      return 1;
    }
  }
  for (const auto& [tick, in_b] : b.ticks()) {
    if (a.ticks().contains(tick)) continue;
    std::cout << fmt::format("the first run has no tick {}\n", tick);
    return 1;
  }
  if (!is_a_whole || !is_b_whole) {
    std::cout << fmt::format(
        "{} ticks in both; cannot tell whether the runs are the same: {} "
        "damaged or incomplete\n",
        a.ticks().size(),
        is_a_whole   ? "the second log is"
        : is_b_whole ? "the first log is"
                     : "both logs are");
    return 1;
  }
  std::cout << fmt::format("{} ticks, all the same\n", a.ticks().size());
  return 0;
}

}  // namespace

void AddDiff(CLI::App& app, Action* action) {
  auto runs = std::make_shared<std::pair<std::string, std::string>>();
  CLI::App* command = app.add_subcommand(
      "diff",
      "Find the first tick and channel in which two runs differ. Exit code 1 "
      "if they differ, or if a log is too damaged to tell.\n"
      "Example: cell diff runs/demo-0001 runs/sim-0001");
  command->add_option("first", runs->first, "run folder")->required();
  command->add_option("second", runs->second, "run folder")->required();
  command->callback([=] {
    *action = [=] {
      return RunDiff(runs->first, runs->second);
    };
  });
}

}  // namespace cell::cli
