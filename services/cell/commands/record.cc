#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "cell/episode_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/lcm_port.h"
#include "common/node/cell_files.h"
#include "common/node/number_option.h"
#include "common/node/run_service.h"
#include "common/text/counted.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/cell_address.h"
#include "services/cell/running/progress.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/traffic.h"
#include "services/recorder/rotating_log.h"

namespace cell::cli {

using namespace recorder;
namespace {

struct RecordOptions {
  CellAddress address;
  std::string deploy_dir;
  std::string out;
  double duration_s = 0;
};

// All messages of the cell, in the order of arrival.
class Recording {
 public:
  Recording(const LcmAddress& address, const std::string& out,
            const CellFiles& files)
      : run_(RunFolder::Create(out, "record", files.deployment, "", 0)),
        log_(run_.path, RotatingLog::ParamsFromConfig(
                            files.deployment.ForService("recorder"))),
        traffic_(files.roster.NumListed()),
        port_(address.MainUrl()) {
    port_.Subscribe(".*", [this](const std::string& channel, Bytes bytes) {
      auto message = traffic_.OnMessage(channel, std::move(bytes));
      if (!message) return;
      KeepWhatWasAsked(*message);
      messages_.push_back(*std::move(message));
    });
  }

  /// @throws std::runtime_error, e.g. when the disk is full.
  void Run(double duration_s, const std::atomic<bool>& stop) {
    constexpr int kWaitMs = 50;
    while (!stop && (duration_s == 0 || clock_.ElapsedSeconds() < duration_s)) {
      WaitForAny({&port_}, kWaitMs);
      port_.Drain();
      num_messages_ += static_cast<int64_t>(messages_.size());
      const auto failure = log_.Append(std::exchange(messages_, {}));
      if (failure) throw std::runtime_error(*failure);
    }
  }

  /// Reports what was recorded; returns 1 if messages, or all of them, are
  /// missing.
  int Finish() {
    const Traffic::Report report = traffic_.MakeReport(clock_.ElapsedSeconds());
    int64_t num_lost = 0;
    for (const Traffic::Channel& channel : report.channels) {
      if (channel.num_lost == 0) continue;
      num_lost += channel.num_lost;
      std::cout << fmt::format("{}: {} lost\n", Printable(channel.name),
                               channel.num_lost);
    }
    std::cout << fmt::format(
        "{}: {} of {} in {:.1f} s, {} lost{}\n", run_.path.string(),
        Counted(num_messages_, "message"),
        Counted(static_cast<int64_t>(report.channels.size()), "channel"),
        clock_.ElapsedSeconds(), num_lost,
        report.num_foreign == 0
            ? ""
            : "; left out " + Counted(report.num_foreign, "message") +
                  " that no service of the cell sent");
    if (num_messages_ > 0) return num_lost > 0 ? 1 : 0;
    run_.Discard();
    std::cout << "no cell was heard: is one running on this network? See `cell "
                 "status` and docs/operating.md\n";
    return 1;
  }

 private:
  // The demonstration and seed that the cell was started with; each EPISODE
  // repeats them.
  void KeepWhatWasAsked(const Message& message) {
    if (message.channel != "EPISODE" || !run_.demonstration.empty()) return;
    const auto episode = Decode<episode_t>(message);
    if (!episode) return;
    run_.AskFor(episode->demonstration, static_cast<uint64_t>(episode->seed));
  }

  RunFolder run_;
  RotatingLog log_;
  Traffic traffic_;
  LcmPort port_;
  Progress clock_;
  std::vector<Message> messages_;
  int64_t num_messages_ = 0;
};

int RunRecord(const RecordOptions& options) {
  const LcmAddress address = options.address.Reach();
  Recording recording(address, options.out, FindCellFiles(options.deploy_dir));
  recording.Run(options.duration_s, StopOnSignals());
  return recording.Finish();
}

}  // namespace

void AddRecord(CLI::App& app, Action* action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = app.add_subcommand(
      "record",
      "Record the cell running on this network, in addition to its own "
      "recorder, until Ctrl-C. The result is a run folder for `cell replay`, "
      "`cell view` and `cell log`. "
      "Exit code 1 if a message was lost.\n"
      "Example: cell record --seconds 10 --out glimpse");
  options->address.AddTo(*command);
  command->add_option("--deploy", options->deploy_dir,
                      "folder with config/ and tasks/");
  command->add_option("--out", options->out,
                      "run folder to create (default: runs/record-...)");
  command->add_option("--seconds", options->duration_s, "stop after this many")
      ->check(NumberIn(0.1, 86400.));
  command->callback([=] {
    *action = [=] {
      return RunRecord(*options);
    };
  });
}

}  // namespace cell::cli
