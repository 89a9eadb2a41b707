#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/live_log.h"
#include "common/bus/live_replay.h"
#include "common/bus/replay.h"
#include "common/bus/run_log.h"
#include "common/node/number_option.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/explaining/action_explainer.h"
#include "services/cell/explaining/decision_explainer.h"
#include "services/cell/running/run_folder.h"
#include "services/planner/planner.h"

namespace cell::cli {
namespace {

constexpr char kPlanner[] = "planner";
constexpr char kRecognition[] = "recognition";
constexpr char kDecisions[] = "decisions";

struct ExplainOptions {
  std::string run;
  double at = 0;      // [s]
  std::string about;  // empty: everything
  bool is_verbose = false;
};

bool HasPlanner(const Roster& roster) {
  return std::ranges::any_of(
      roster.entries, [](const auto& entry) { return entry.name == kPlanner; });
}

/// Makes the planner of the run decide again. Returns where it decides
/// otherwise than the log says, as a planner of another build may.
std::optional<std::string> Decide(const RunFolder& run,
                                  DecisionExplainer* decisions) {
  const ServiceFactory factory = [&](Bus& bus) {
    return planner::MakeObservedPlanner(bus, run.deployment,
                                        decisions->Observer());
  };
  if (LiveLog::IsLive(RequireLogsOf(run.path))) {
    const LiveLog log = LiveLog::Load(run.path);
    return ReplayLive(log, run.roster, kPlanner, factory).difference;
  }
  const RunLog log = RunLog::Load(run.path);
  return Replay(log, run.roster, kPlanner, factory).difference;
}

void Recognise(const RunFolder& run, ActionExplainer* actions) {
  if (LiveLog::IsLive(RequireLogsOf(run.path))) {
    const LiveLog log = LiveLog::Load(run.path);
    for (const Message* message : log.InOrder()) actions->Put(*message);
    return;
  }
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [k, tick] : log.ticks()) {
    std::vector<Message> messages = tick.messages;
    std::ranges::sort(messages, OrderedBefore);
    for (const Message& message : messages) actions->Put(message);
  }
}

/// The first and the last tick of the log.
std::pair<int32_t, int32_t> TicksOf(const RunFolder& run) {
  if (!LiveLog::IsLive(RequireLogsOf(run.path))) {
    const RunLog log = RunLog::Load(run.path);
    return {log.ticks().begin()->first, log.ticks().rbegin()->first};
  }
  const LiveLog log = LiveLog::Load(run.path);
  const std::vector<const Message*> messages = log.InOrder();
  if (messages.empty()) return {0, 0};
  return {messages.front()->tick, messages.back()->tick};
}

/// @throws std::runtime_error if the log says nothing of the moment [us].
void RequireWithin(const RunFolder& run, int64_t utime) {
  const auto [first, last] = TicksOf(run);
  const int64_t begin = first * kTickUs;
  const int64_t end = last * kTickUs;
  // As times are printed, they may be half a hundredth of a second off.
  constexpr int64_t kRounding = 5'000;
  if (utime >= begin - kRounding && utime <= end + kRounding) return;
  throw std::runtime_error(fmt::format(
      "{}: --at {:.2f} s is outside the log, which goes from {:.2f} to {:.2f} "
      "s",
      run.path.string(), 1e-6 * static_cast<double>(utime),
      1e-6 * static_cast<double>(begin), 1e-6 * static_cast<double>(end)));
}

void Print(const Explanation& explanation) {
  std::cout << fmt::format("at {:.2f} s {}\n",
                           static_cast<double>(explanation.utime) * 1e-6,
                           Printable(explanation.what));
  for (const std::string& reason : explanation.reasons) {
    std::cout << "  " << Printable(reason) << '\n';
  }
}

int RunExplain(const ExplainOptions& options) {
  RunFolder run = RunFolder::Open(options.run);
  const auto at = static_cast<int64_t>(options.at * 1e6);
  RequireWithin(run, at);
  // As a live run was recorded; for others it makes no difference.
  run.deployment.has_operator = LiveLog::IsLive(RequireLogsOf(run.path));
  ActionExplainer actions(recognizer::Recognizer::Params::Load(run.deployment));
  DecisionExplainer decisions(options.is_verbose);
  std::vector<const Explainer*> explainers;
  if (options.about != kDecisions) {
    Recognise(run, &actions);
    explainers.push_back(&actions);
  }
  if (options.about != kRecognition && HasPlanner(run.roster)) {
    if (const auto difference = Decide(run, &decisions)) {
      std::cerr << Printable(options.run + ": the planner of this build " +
                             "decides otherwise than the log says (" +
                             *difference +
                             "): only what it decided before is explained")
                << '\n';
    }
    explainers.push_back(&decisions);
  }
  bool has_any = false;
  for (const Explainer* explainer : explainers) {
    const auto nearest = NearestTo(at, explainer->Utimes());
    if (!nearest) continue;
    for (const Explanation& why : explainer->At(*nearest)) Print(why);
    has_any = true;
  }
  if (has_any) return 0;
  throw std::runtime_error(options.run + ": the log shows nothing to explain");
}

}  // namespace

void AddExplain(CLI::App& app, Action* action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand(
      "explain",
      "Say why the manipulation and the decision that are nearest to a moment "
      "of a recorded run were so.\n"
      "Of a manipulation: why it was recognised, or why it was unknown: which "
      "model, what of it held, and what the next best one lacked.\n"
      "Of a decision: why an arm was asked for an action, why the person was "
      "asked or warned, what the plan was: the rule that covers the action, "
      "what it and the best others are worth, what had failed, which "
      "preconditions are missing, which steps a mistake has added.\n"
      "Recognizer and planner compute it again from the log.\n"
      "Example: cell explain runs/demo-0001 --at 41.5");
  command->add_option("run", options->run, "run folder")->required();
  command->add_option("--at", options->at, "s since the start of the run")
      ->check(NumberIn(0.0, 1e9))
      ->required();
  command
      ->add_option("--about", options->about,
                   "only recognition, or only decisions (default: both)")
      ->check(CLI::IsMember({kRecognition, kDecisions}));
  command->add_flag("--verbose", options->is_verbose,
                    "also all other actions: how much worse they are, or why "
                    "they are not possible");
  command->callback([=] {
    *action = [=] {
      return RunExplain(*options);
    };
  });
}

}  // namespace cell::cli
