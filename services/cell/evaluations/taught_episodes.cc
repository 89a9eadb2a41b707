#include "services/cell/evaluations/taught_episodes.h"

#include <algorithm>

#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "common/bus/decode.h"
#include "services/cell/evaluations/assembly_row.h"

namespace cell::cli {

TaughtEpisodes::TaughtEpisodes(const Task& task,
                               const SuccessCriterion& success)
    : task_(task), success_(success) {}

void TaughtEpisodes::Put(const Message& message) {
  if (message.channel == "EPISODE") OnEpisode(message);
  if (episodes_.empty() || episodes_.back()->has_ended) return;
  Episode& episode = *episodes_.back();
  episode.assembly.Put(message);
  episode.check.Put(message);
  if (message.channel == "TRUTH_ACTIONS") ++episode.num_demonstrations;
  if (message.channel != "EXECUTION") return;
  const auto execution = Decode<execution_t>(message);
  if (!execution || execution->state != execution_t::STUCK) return;
  const auto& asked = episode.questions;
  if (asked.empty() || asked.back() != execution->text) {
    episode.questions.push_back(execution->text);
  }
}

/// Between episodes the parts are laid out anew, which is no motion of arms.
void TaughtEpisodes::OnEpisode(const Message& message) {
  const auto episode = Decode<episode_t>(message);
  if (!episode) return;
  if (episode->phase == episode_t::START) {
    episodes_.push_back(std::make_unique<Episode>(task_, success_));
    episodes_.back()->start_utime = episode->header.utime;
  } else if (episode->phase == episode_t::END && !episodes_.empty()) {
    episodes_.back()->has_ended = true;
  }
}

nlohmann::json TaughtEpisodes::Rows() const {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& episode : episodes_) {
    nlohmann::json row =
        AssemblyRow(episode->assembly, episode->check, task_.parts);
    row["seconds"] =
        1e-6 * static_cast<double>(episode->assembly.record().last_utime -
                                   episode->start_utime);
    row["questions"] = episode->questions;
    row["demonstrations"] = episode->num_demonstrations;
    rows.push_back(std::move(row));
  }
  return rows;
}

bool IsTaughtFrom(const nlohmann::json& episodes, size_t first) {
  if (episodes.size() <= first) return false;
  return std::all_of(episodes.begin() + static_cast<std::ptrdiff_t>(first),
                     episodes.end(), [](const nlohmann::json& episode) {
                       return episode.at("questions").empty() &&
                              episode.at("complete") == true;
                     });
}

}  // namespace cell::cli
