#include "services/cell/commands/search_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "common/files/draft.h"
#include "common/node/run_service.h"
#include "common/text/fingerprint.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

/// Counts the changes of what a planner saves.
constexpr int kSearchFormat = 1;
constexpr int64_t kFirstSave = 50'000;  // expansions, a few seconds
constexpr char kAnotherSearch[] =
    "go on from it with --resume, or choose another --save";

}  // namespace

SearchFile::SearchFile(fs::path path, const std::string& question,
                       bool is_resumed)
    : path_(std::move(path)),
      title_(fmt::format("search of cell plan {}, format {}, {:016x}\n",
                         CELL_VERSION, kSearchFormat, Fingerprint(question))),
      is_resumed_(is_resumed),
      next_save_(kFirstSave) {
  if (!is_resumed) RequireFree(path_, kAnotherSearch);
}

void SearchFile::Restore(planning::Planner* planner) const {
  if (!is_resumed_ || !fs::exists(path_)) return;
  std::ifstream file(path_, std::ios::binary);
  std::string title(title_.size(), '\0');
  file.read(title.data(), static_cast<std::streamsize>(title.size()));
  if (!file || title != title_) {
    throw std::runtime_error(fmt::format(
        "{}: holds no search of this version for the same domain, problem and "
        "--precision; choose another --save",
        path_.string()));
  }
  try {
    planner->Restore(&file, fs::file_size(path_) - title.size());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}; remove it to begin anew",
                                         path_.string(), error.what()));
  }
}

void SearchFile::Save(const planning::Planner& planner) const {
  Draft draft(path_);
  std::ofstream file(draft.path(), std::ios::binary);
  file << title_;
  planner.Save(&file);
  file.close();
  if (!file) {
    throw std::runtime_error(path_.string() +
                             ": cannot be written: " + std::strerror(errno));
  }
  draft.Replace();
}

planning::Planner::Watch SearchFile::SaveWhile(
    const planning::Planner* planner) {
  const std::atomic<bool>& stop = StopOnSignals();
  return [this, planner, &stop](const planning::Planner::Progress& progress) {
    is_stopped_ |= stop && !progress.is_last;
    if (progress.is_last || progress.num_expansions >= next_save_) {
      Save(*planner);
      next_save_ = std::max(
          kFirstSave, progress.num_expansions + progress.num_expansions / 2);
    }
    return !is_stopped_;
  };
}

void SearchFile::ThrowIfStopped() const {
  if (!is_stopped_) return;
  throw std::runtime_error(
      fmt::format("stopped; the search is in {}: repeat the command with "
                  "--resume to go on",
                  path_.string()));
}

}  // namespace cell::cli
