#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cell/command_episode_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/lcm_port.h"
#include "services/cell/commands.h"

namespace cell {
namespace {

struct EpisodeOptions {
  std::string action = "end";
  std::string url = "udpm://239.255.76.67:7667";
  std::string demonstration;
  int64_t seed = 1;
  double deadline_s = 1;
};

// The cell's time now, from its next TICK.
int64_t AwaitTick(LcmPort& port) {
  std::optional<int64_t> utime;
  port.Subscribe(kTickChannel, [&](const std::string&, Bytes bytes) {
    if (bytes.size() >= kWireHeaderEnd) utime = ReadWireHeader(bytes).utime;
  });
  constexpr int kPatienceMs = 2000;
  constexpr int kStepMs = 20;
  for (int waited = 0; waited < kPatienceMs && !utime; waited += kStepMs) {
    WaitForAny({&port}, kStepMs);
    port.Drain();
  }
  if (!utime) {
    throw std::runtime_error(
        "no TICK heard in 2 s: does the cell run, and on "
        "this --url?");
  }
  return *utime;
}

int CommandEpisode(const EpisodeOptions& options) {
  const LcmAddress address = LcmAddress::Parse(options.url);
  LcmPort main(address.MainUrl());
  LcmPort control(address.ControlUrl());
  command_episode_t command{};
  command.header.utime = AwaitTick(main);
  command.deadline_utime =
      command.header.utime + static_cast<int64_t>(options.deadline_s * 1e6);
  command.action = options.action == "start" ? command_episode_t::START
                                             : command_episode_t::END;
  command.demonstration = options.demonstration;
  command.seed = options.seed;
  control.Publish("COMMAND_EPISODE", Bus::Encode(command));
  std::cout << fmt::format("asked the clock to {} the episode, by {:.2f} s\n",
                           options.action,
                           static_cast<double>(command.deadline_utime) * 1e-6);
  return 0;
}

}  // namespace

void AddEpisode(CLI::App& app, Action* action) {
  auto options = std::make_shared<EpisodeOptions>();
  CLI::App* command = app.add_subcommand(
      "episode",
      "Begin or end an episode of a cell that runs on this network (a `cell "
      "demo` has one of its own).\n"
      "Example: cell episode start --demonstration assembly --seed 3");
  command->add_option("action", options->action, "start or end")
      ->required()
      ->check(CLI::IsMember({"start", "end"}));
  command->add_option("--url", options->url)->capture_default_str();
  command->add_option("--demonstration", options->demonstration,
                      "script of the task, for start");
  command->add_option("--seed", options->seed)->capture_default_str();
  command
      ->add_option("--deadline", options->deadline_s,
                   "not executed later than so many seconds of the cell's time")
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return CommandEpisode(*options);
    };
  });
}

}  // namespace cell
