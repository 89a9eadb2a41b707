#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/bus/live_log.h"
#include "common/bus/run_log.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/explaining/action_explainer.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

struct ExplainOptions {
  std::string run;
  double at = 0;  // [s]
};

void PutAll(const RunFolder& run, Explainer* explainer) {
  if (LiveLog::IsLive(RequireLogsOf(run.path))) {
    const LiveLog log = LiveLog::Load(run.path);
    for (const Message* message : log.InOrder()) explainer->Put(*message);
    return;
  }
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [k, tick] : log.ticks()) {
    std::vector<Message> messages = tick.messages;
    std::ranges::sort(messages, OrderedBefore);
    for (const Message& message : messages) explainer->Put(message);
  }
}

int RunExplain(const ExplainOptions& options) {
  const RunFolder run = RunFolder::Open(options.run);
  ActionExplainer explainer(
      recognizer::Recognizer::Params::Load(run.deployment));
  PutAll(run, &explainer);
  const auto utime = static_cast<int64_t>(options.at * 1e6);
  const auto nearest = NearestTo(utime, explainer.explanations());
  if (!nearest) {
    throw std::runtime_error(options.run +
                             ": the log shows no manipulation to explain");
  }
  for (const Explanation& explanation : explainer.explanations()) {
    if (explanation.utime != nearest->utime) continue;
    std::cout << fmt::format("at {:.2f} s {}\n",
                             static_cast<double>(explanation.utime) * 1e-6,
                             Printable(explanation.what));
    for (const std::string& reason : explanation.reasons) {
      std::cout << "  " << Printable(reason) << '\n';
    }
  }
  return 0;
}

}  // namespace

void AddExplain(CLI::App& app, Action* action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand(
      "explain",
      "Say why the action nearest to a moment of a recorded run was "
      "recognised, or why it was unknown: which model, what of it held, and "
      "what the next best one lacked. Computed again from the log.\n"
      "Example: cell explain runs/demo-0001 --at 41.5");
  command->add_option("run", options->run, "run folder")->required();
  command->add_option("--at", options->at, "s since the start of the run")
      ->check(CLI::Range(0.0, 1e9))
      ->required();
  command->callback([=] {
    *action = [=] {
      return RunExplain(*options);
    };
  });
}

}  // namespace cell::cli
