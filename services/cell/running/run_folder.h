#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/bus/roster.h"
#include "common/config/deployment.h"

namespace cell::cli {

/// A folder that holds everything a run needs to be repeated and replayed: its
/// log, the configuration and task it ran with, the texts of its message types
/// and what was asked for (run.yaml). Storage adapter.
struct RunFolder {
  std::filesystem::path path;
  Deployment deployment;  ///< the folder's own copy
  Roster roster;
  std::string demonstration;
  uint64_t seed = 0;
  /// The library that the run begins with.
  struct LibraryVersion {
    std::string file;    ///< empty: the actions of the task
    int64_t change = 0;  ///< the last one that was made to it
    std::string build;   ///< that made it
  };
  LibraryVersion library;

  /// Makes `path` (must not exist or be empty; "" picks runs/<kind>-<number>
  /// here) and copies `source` into it.
  /// @throws std::runtime_error naming the folder.
  static RunFolder Create(const std::string& path, const std::string& kind,
                          const Deployment& source,
                          const std::string& demonstration, uint64_t seed);

  /// The services of the roster with this option take part in this run.
  /// @throws ConfigError if there is none.
  void EnableServices(const std::string& option);
  /// The planner of this run asks a person for these actions.
  void LeaveToPerson(const std::vector<std::string>& actions) const;
  /// The recognizer of this run has no event chain at first, and learns them.
  void ForgetEventChains() const;
  /// The cell of this run knows no action but those of which the task says by
  /// hand what they do, the arms' own skills: it learns how actions look and
  /// what they need and do. Arms may do what was learned without an operator.
  void LearnFromNothing() const;
  /// What is shown and tried in this run changes what recognizer and planner
  /// know, or does not.
  void SetLearning(bool is_learning) const;
  /// Arms may do what was learned without an operator's confirmation.
  void DoWithoutConfirmation() const;
  /// The run works on this library's file, which outlives it.
  /// @throws std::runtime_error if it cannot be used.
  void UseLibrary(const std::filesystem::path& file);
  /// Keeps the demonstration and seed of the run: a recording of another
  /// process's cell learns them only later. @throws std::runtime_error naming
  /// the file.
  void AskFor(const std::string& demonstration, uint64_t seed);
  /// @throws std::runtime_error always: the user has stopped the run, and its
  /// log is here.
  [[noreturn]] void Stopped() const;
  /// Removes it: the run never began.
  void Discard() const;
  /// @throws std::runtime_error or ConfigError if it is not a run folder.
  static RunFolder Open(const std::string& path);

 private:
  void Fill(const Deployment& source);
};

/// Makes RUNS/<kind>-<number> with the first free number; of several callers at
/// once each gets a folder of its own.
std::filesystem::path ClaimRunFolder(const std::filesystem::path& runs,
                                     const std::string& kind);

/// Makes `link`, beside the run folder, a symbolic link to it.
void PointTo(const std::filesystem::path& run,
             const std::filesystem::path& link);

}  // namespace cell::cli
