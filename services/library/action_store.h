#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/actions/action_record.h"

namespace cell::library {

/// What keeps the actions failed: what() names the file, and what to do.
/// Nothing that was stored before is lost.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

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

/// Keeps action records; ids ascend in the order of storing. A record of a
/// higher version replaces those of its name. Records stored in a run carry its
/// tick, so that a restarted service can remove those not yet answered, and
/// restore those that they had replaced. What a library held before each of its
/// last changes is kept, too. Every call may throw StoreError.
class ActionStore {
 public:
  ActionStore() = default;
  ActionStore(const ActionStore&) = delete;
  ActionStore& operator=(const ActionStore&) = delete;
  virtual ~ActionStore() = default;

  /// Keeps all of them or none: when it returns, they outlive the process. The
  /// records' own ids do not count. Their ids.
  /// @throws std::invalid_argument for a name that is there already with this
  /// version or a higher one.
  virtual std::vector<int64_t> Store(std::span<const ActionRecord> records,
                                     int32_t tick) = 0;

  /// Also one that was replaced in this run.
  virtual std::optional<ActionRecord> Find(int64_t id) const = 0;
  /// The latest version.
  virtual std::optional<ActionRecord> FindNamed(
      const std::string& name) const = 0;
  /// The latest version of each name, by id.
  virtual std::vector<ActionRecord> All() const = 0;
  /// What All() was before the run.
  virtual std::vector<ActionRecord> BeforeRun() const = 0;
  /// How many names.
  virtual int64_t Count() const = 0;

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
  /// All() before the change; nullopt if there is none of this number.
  virtual std::optional<std::vector<ActionRecord>> ContentBefore(
      int64_t number) const = 0;

  virtual int schema_version() const = 0;
};

/// The tick of what was there before the run.
inline constexpr int32_t kBeforeRun = -1;

}  // namespace cell::library
