#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cell/experience_t.hpp"

namespace cell {

/// An experience by names, as a library keeps it: it outlives a domain that
/// does not have its action yet, or some of its objects.
struct ExperienceRecord {
  static constexpr size_t kMaxBytes = 65'536;  ///< of its message

  int64_t id = 0;  ///< from 1 in the order of storing; 0: not stored
  std::string action;
  std::vector<std::string> objects;  ///< of the action
  std::string agent;                 ///< person, robot
  /// Ground atoms that were true, "On(a, b)", or unknown, "?On(a, b)"; all
  /// others were false.
  std::vector<std::string> before;
  std::vector<std::string> after;
  std::string demonstration;  ///< in which it was made; empty: not known

  bool operator==(const ExperienceRecord&) const = default;
};

/// All but the demonstration, which a message does not say.
ExperienceRecord ToRecord(const experience_t& message);
/// All but the header. @throws std::invalid_argument naming a text that is no
/// ground atom.
experience_t ToMessage(const ExperienceRecord& record);

/// The text as in ExperienceRecord; nullopt if it is none.
std::optional<literal_t> ParseAtom(const std::string& text);

}  // namespace cell
