#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "services/library/library_content.h"

namespace cell::library {

/// What keeps the actions failed: what() names the file, and what to do.
/// Nothing that was stored before is lost.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a StoreError says of a file with content that cannot be read.
inline constexpr char kDamagedStore[] =
    "is damaged; move it away and import the copy of a run folder: cell "
    "library import RUN/library.json --database FILE";

/// The message of a StoreError for a file that another process has locked.
inline constexpr char kOwnedByAnother[] =
    "another process owns it; end that one first (a cell that runs owns its "
    "library)";

/// What was done to a library, all of it: a command, or a run.
struct StoreChange {
  int64_t number = 0;  ///< from 1; the last one's is the library's version
  std::string what;
  std::string build;  ///< that did it
};

/// Keeps action records and experiences; the ids of each ascend in the order of
/// storing. A record of a higher version replaces those of its name; an
/// experience stays as it is until it is removed. What is stored in a run
/// carries its tick, so that a restarted service can remove what was not yet
/// answered, and restore what that had replaced or removed. What a library held
/// before each of its last changes is kept, too. Every call may throw
/// StoreError.
class ActionStore {
 public:
  ActionStore() = default;
  ActionStore(const ActionStore&) = delete;
  ActionStore& operator=(const ActionStore&) = delete;
  virtual ~ActionStore() = default;

  /// Does all of it or nothing: when it returns, it outlives the process. The
  /// ids that records and experiences have do not count.
  /// @throws std::invalid_argument for a name that is there already with this
  /// version or a higher one, and for a removed experience that is not there.
  virtual StoredIds Apply(const StoreEdit& edit, int32_t tick) = 0;
  /// The same, of records alone. Their ids.
  std::vector<int64_t> Store(std::span<const ActionRecord> records,
                             int32_t tick) {
    return Apply({.records = {records.begin(), records.end()}}, tick).records;
  }
  /// Of one experience. Its id.
  int64_t Keep(const ExperienceRecord& experience, int32_t tick) {
    return Apply({.experiences = {experience}}, tick).experiences.front();
  }

  /// Also one that was replaced in this run.
  virtual std::optional<ActionRecord> Find(int64_t id) const = 0;
  /// The latest version.
  virtual std::optional<ActionRecord> FindNamed(
      const std::string& name) const = 0;
  /// The latest version of each name, by id.
  virtual std::vector<ActionRecord> All() const = 0;
  /// How many names.
  virtual int64_t Count() const = 0;

  static constexpr int64_t kAllExperiences =
      std::numeric_limits<int64_t>::max();
  /// Those with this id or a higher one, by id; the first so many.
  virtual std::vector<ExperienceRecord> ExperiencesFrom(int64_t first_id,
                                                        int64_t max) const = 0;
  std::vector<ExperienceRecord> Experiences() const {
    return ExperiencesFrom(1, kAllExperiences);
  }
  virtual int64_t NumExperiences() const = 0;

  virtual LibraryContent Content() const = 0;
  /// What Content() was before the run.
  virtual LibraryContent BeforeRun() const = 0;

  /// A run begins: all that is there now was there before its first tick. What
  /// has been replaced is forgotten.
  virtual void BeginRun() = 0;
  /// Forgets what was stored in `tick` of this run and later.
  virtual void RollBackTo(int32_t tick) = 0;

  /// What is stored from now on belongs to this change. One that has changed
  /// nothing is forgotten.
  virtual void BeginChange(const std::string& what) = 0;
  /// The last of them, by number.
  static constexpr int64_t kMaxChanges = 100;
  virtual std::vector<StoreChange> Changes() const = 0;
  /// By which the record with this id was stored; nullopt if that is not kept.
  virtual std::optional<StoreChange> ChangeOf(int64_t id) const = 0;
  /// Content() before the change; nullopt if there is none of this number.
  virtual std::optional<LibraryContent> ContentBefore(int64_t number) const = 0;

  virtual int schema_version() const = 0;
};

/// The tick of what was there before the run.
inline constexpr int32_t kBeforeRun = -1;

}  // namespace cell::library
