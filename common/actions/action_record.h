#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cell {

/// An action model as it is stored and sent. The texts are blocks of an action
/// in a task's domain.yaml: ReadActionModel(), WriteActionModel().
struct ActionRecord {
  struct Argument {
    std::string name;
    std::string type;
    bool operator==(const Argument&) const = default;
  };
  static constexpr size_t kMaxBytes = 65'536;  ///< of all of it, as JSON
  static constexpr int64_t kMaxVersion = 1'000'000'000;

  int64_t id = 0;       ///< from 1 in the order of storing; 0: not stored
  int64_t version = 1;  ///< counts the records of this name from 1
  std::string name;     ///< its symbol
  std::vector<Argument> arguments;
  std::vector<std::string> agents;  ///< person, robot; none: it is removed
  std::string undoes;  ///< name of the action that it takes back; empty: none
  std::string sec;     ///< how it is recognised; empty: never
  std::string rules;   ///< what it does
  std::string robot;   ///< what a robot needs and does besides
  std::string skill;   ///< how an arm does it; empty: no arm can
  std::string skill_settings;  ///< section of the task's skills.yaml

  /// A removed action: only its name, arguments and version are kept, and no
  /// agent can do it.
  bool is_removed() const { return agents.empty(); }
  bool operator==(const ActionRecord&) const = default;
};

/// The next version of the record, by which it is removed.
ActionRecord Removed(const ActionRecord& record);

}  // namespace cell
