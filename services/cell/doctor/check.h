#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/bus/lcm_port.h"
#include "services/cell/doctor/machine.h"

namespace cell::cli {

/// What is examined, and where.
struct Site {
  std::string root;         ///< the machine's files; "": /
  std::string deploy_dir;   ///< with config/ and tasks/
  std::string shipped_dir;  ///< the same as it came with the programs
  std::string program_dir;
  std::string runs_dir;
  std::string run_dir;  ///< one that is to be replayed; may be empty
  LcmAddress address;
  bool is_several_hosts = false;  ///< ttl > 0 is meant
  int64_t min_free_bytes = int64_t{2} << 30;
};

/// The result of one check.
struct Diagnosis {
  enum class Level { kOk, kWarning, kBad };
  Level level = Level::kOk;
  std::string what;
  std::string fix;  ///< a command, unless kOk

  static Diagnosis Ok(std::string what) {
    return {Level::kOk, std::move(what), ""};
  }
  static Diagnosis Warning(std::string what, std::string fix) {
    return {Level::kWarning, std::move(what), std::move(fix)};
  }
  static Diagnosis Bad(std::string what, std::string fix) {
    return {Level::kBad, std::move(what), std::move(fix)};
  }
};

/// One thing that a cell needs. Reads, changes nothing.
struct Check {
  std::string name;
  std::function<Diagnosis(const Machine&, const Site&)> run;
};

/// "BAD  receive buffer: ...; fix: ..."
std::string ToString(const std::string& check, const Diagnosis& diagnosis);

}  // namespace cell::cli
