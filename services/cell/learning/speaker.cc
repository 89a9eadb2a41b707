#include "services/cell/learning/speaker.h"

namespace cell::cli {

std::optional<command_name_t> Speaker::Answer(const recognised_action_t& action,
                                              const vtb::Script& script) const {
  if (action.kind != recognised_action_t::UNKNOWN) return std::nullopt;
  command_name_t command{};
  if (!script.lay_down.empty()) {
    command.name = demonstrations_.raising;
    command.is_undone = 1;
  } else {
    const Part* part = parts_.Find(action.part);
    for (const auto& [name, rule] : demonstrations_.rules) {
      if (part != nullptr && rule.part_type == part->type) {
        command.name = rule.called;
      }
    }
  }
  if (command.name.empty()) return std::nullopt;
  return command;
}

}  // namespace cell::cli
