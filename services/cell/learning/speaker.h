#pragma once

#include <optional>

#include "cell/command_name_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "common/parts/part_table.h"
#include "services/vtb/script.h"

namespace cell::cli {

/// What the testbed's person says when the cell does not know what was shown:
/// the name that demonstrators.yaml gives to the placement of such a part, or
/// that the action is undone by laying it down.
class Speaker {
 public:
  Speaker(const vtb::Demonstrations& demonstrations, const PartTable& parts)
      : demonstrations_(demonstrations), parts_(parts) {}

  /// Without a deadline. Nothing if the action has a name, or the person does
  /// not know one.
  /// @param script  that the person follows
  std::optional<command_name_t> Answer(const recognised_action_t& action,
                                       const vtb::Script& script) const;

 private:
  const vtb::Demonstrations& demonstrations_;
  const PartTable& parts_;
};

}  // namespace cell::cli
