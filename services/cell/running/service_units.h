#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::cli {

/// One of the cell's units as systemd sees it.
struct ServiceUnit {
  std::string name;   ///< "cell-tracker.service"
  std::string state;  ///< "active (running)"
  bool is_active = false;
  bool is_failed = false;
  int64_t num_restarts = 0;
  int64_t pid = 0;           ///< 0: no process
  double processor_s = 0;    ///< [s] since its start; 0 if not accounted
  int64_t memory_bytes = 0;  ///< 0 if not accounted
  std::string since;         ///< of its state
  std::string last_words;    ///< why it failed, as reported to the manager
};

/// The cell's units under the system's manager or the user's own (--user), by
/// systemctl. Device adapter.
class ServiceManager {
 public:
  explicit ServiceManager(bool is_user) : is_user_(is_user) {}

  bool is_user() const { return is_user_; }

  /// Starts or stops cell.target and waits for it.
  /// @throws std::runtime_error with what is missing and what to do.
  void Start() const;
  void Stop() const;

  /// Of all units named cell-*.service that are loaded, by name.
  /// @throws std::runtime_error if no manager answers.
  std::vector<ServiceUnit> Units() const;

  /// The unit's last lines in the journal; where there is none, its
  /// `last_words`.
  std::vector<std::string> LastLinesOf(const ServiceUnit& unit) const;
  /// "journalctl --user -u 'cell-*'"
  std::string JournalCommand() const;

 private:
  std::string Run(const std::string& arguments) const;

  bool is_user_;
};

/// Reads the answer of `systemctl show`: blocks of KEY=value, empty lines
/// between. Blocks without Id are left out.
std::vector<ServiceUnit> ParseUnits(const std::string& text);

}  // namespace cell::cli
