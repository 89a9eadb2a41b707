#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "cell/episode_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/run_log.h"
#include "common/scene/key_frame.h"
#include "common/sec/chain_similarities.h"
#include "common/sec/event_chain.h"
#include "common/task/task.h"
#include "common/text/nearest.h"
#include "common/text/printable.h"
#include "services/cell/commands/commands.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {
namespace {

struct ChainOptions {
  std::string run;
  std::string object;
  std::string other;
  std::string measure = "same_pair";
};

bool IsStart(const Message& message) {
  if (message.channel != "EPISODE") return false;
  const auto episode = Decode<episode_t>(message);
  return episode && episode->phase == episode_t::START;
}

/// The event chain of each episode of a run. @throws std::runtime_error if it
/// has no key frames.
std::vector<EventChain> ChainsOf(const RunFolder& run) {
  const SceneObjects scene_objects = LoadTask(run.deployment).scene_objects;
  std::vector<std::vector<KeyFrame>> episodes;
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [tick, entry] : log.ticks()) {
    if (std::ranges::any_of(entry.messages, IsStart)) episodes.emplace_back();
    for (const Message& message : entry.messages) {
      if (message.channel != "KEY_FRAME" || episodes.empty()) continue;
      const auto decoded = Decode<key_frame_t>(message);
      auto frame =
          decoded ? KeyFrameFromMessage(*decoded, scene_objects) : std::nullopt;
      if (frame) episodes.back().push_back(*std::move(frame));
    }
  }
  std::vector<EventChain> chains;
  for (const std::vector<KeyFrame>& frames : episodes) {
    if (!frames.empty()) chains.push_back(ChainOf(frames));
  }
  if (chains.empty()) {
    throw std::runtime_error(run.path.string() +
                             ": the log holds no key frame of an episode");
  }
  return chains;
}

/// The parts, hands and table of a chain, by name.
std::vector<std::string> ObjectsOf(const EventChain& chain) {
  std::set<std::string> names;
  for (const auto& [first, second] : chain.pairs()) {
    names.insert({first, second});
  }
  return {names.begin(), names.end()};
}

/// The rows of a chain that `options` choose, without those that do not change.
EventChain Chosen(const EventChain& chain, const ChainOptions& options) {
  const EventChain rows =
      options.object.empty() ? chain : chain.RowsOf(options.object);
  if (rows.num_rows() == 0) {
    throw std::invalid_argument("--object " + options.object +
                                ": no part, hand, segment or table is named '" +
                                options.object + "'" +
                                NamesInstead(options.object, ObjectsOf(chain)));
  }
  return rows.ChangingRows().DistinctColumns();
}

int ShowChains(const ChainOptions& options) {
  int number = 0;
  for (const EventChain& chain : ChainsOf(RunFolder::Open(options.run))) {
    const EventChain chosen = Chosen(chain, options);
    std::cout << fmt::format("episode {}: {} of {} key frames\n", ++number,
                             chosen.num_columns(), chain.num_columns())
              << ToText(chosen);
  }
  return 0;
}

int CompareChains(const ChainOptions& options) {
  const auto ours = ChainsOf(RunFolder::Open(options.run));
  const auto others = ChainsOf(RunFolder::Open(options.other));
  const auto similarity = MakeChainSimilarity(options.measure);
  for (size_t i = 0; i < std::min(ours.size(), others.size()); ++i) {
    std::cout << fmt::format("episode {}: similarity {:.3f}\n", i + 1,
                             similarity->Between(Chosen(ours[i], options),
                                                 Chosen(others[i], options)));
  }
  return 0;
}

}  // namespace

void AddChain(CLI::App& app, Action* action) {
  auto options = std::make_shared<ChainOptions>();
  CLI::App* command = app.add_subcommand(
      "chain",
      "Show the semantic event chain of each episode of a recorded run: rows "
      "are object pairs whose relation changes, columns are key frames; 0 not "
      "touching, 1 touching, 2 overlapping, 9 absent. Or compare two runs.\n"
      "Example: cell chain runs/sim-0001 --object bolt_1");
  command->add_option("run", options->run, "run folder")->required();
  command->add_option("--object", options->object,
                      "only rows of this part or hand");
  command->add_option("--with", options->other,
                      "compare with the chains of this run folder");
  command
      ->add_option("--measure", options->measure,
                   "similarity measure of --with")
      ->check(CLI::IsMember(ChainSimilarityNames()))
      ->capture_default_str();
  command->callback([=] {
    *action = [=] {
      return options->other.empty() ? ShowChains(*options)
                                    : CompareChains(*options);
    };
  });
}

}  // namespace cell::cli
