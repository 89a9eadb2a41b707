#include "services/cell/learning/experienced_episodes.h"

#include <fstream>
#include <stdexcept>
#include <utility>

#include "common/experiences/experience_text.h"
#include "common/task/shipped_experiences.h"
#include "common/text/byte_order_mark.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

/// Reads the lines below one heading. The lines before it are empty, so that
/// errors name the line of the file.
void AddEpisode(const std::string& name, const std::string& text,
                const fs::path& file, const RuleWorld& world,
                std::vector<ExperiencedEpisode>* episodes) {
  auto experiences = ReadExperiences(text, file.string(), world);
  if (!experiences.empty()) {
    episodes->push_back({name, std::move(experiences)});
  }
}

void AddEpisodes(const fs::path& file, const RuleWorld& world,
                 std::vector<ExperiencedEpisode>* episodes) {
  std::ifstream stream(file);
  std::string name = file.filename().string();
  std::string text;
  std::string above;
  const size_t num_before = episodes->size();
  for (std::string line; std::getline(stream, line); above += "\n") {
    if (above.empty()) line = WithoutByteOrderMark(line);
    if (!line.starts_with("# ")) {
      text += line + "\n";
      continue;
    }
    AddEpisode(name, text, file, world, episodes);
    name = line.substr(2);
    text = above + "\n";
  }
  AddEpisode(name, text, file, world, episodes);
  if (episodes->size() == num_before) {
    throw std::runtime_error(
        file.string() +
        ": holds no experience: a state, an action, and the state after it");
  }
}

}  // namespace

std::vector<ExperiencedEpisode> EpisodesIn(const fs::path& folder,
                                           const RuleWorld& world) {
  std::vector<ExperiencedEpisode> episodes;
  for (const fs::path& file : ExperienceFilesIn(folder)) {
    AddEpisodes(file, world, &episodes);
  }
  if (episodes.empty()) {
    throw std::runtime_error(folder.string() +
                             ": has no experiences (*.experiences); cell rules "
                             "record makes them");
  }
  return episodes;
}

}  // namespace cell::cli
