#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/cell/running/process_group.h"

namespace cell::cli {

/// Decides which services that died are restarted: not those with a lasting
/// reason. A reason lasts if the arguments or files are wrong (kExitUsage), if
/// there is no program, and if a service ends itself twice running with the
/// same last line, except for its numbers. Pure.
class RestartPolicy {
 public:
  /// Why it is not restarted; nullopt if it is. `reason`: its last line of
  /// output, may be empty.
  std::optional<std::string> WhyNot(const ProcessGroup::Death& death,
                                    const std::string& reason);

 private:
  struct Record {
    int num_deaths = 0;
    std::string reason;  // of its last death; empty if it was killed
  };
  std::map<std::string, Record> records_;
};

}  // namespace cell::cli
