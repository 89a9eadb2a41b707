#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::library {

/// An action of the library: what ties the paper's three levels together. The
/// texts are blocks of an action in a task's domain.yaml, so that one reader
/// serves both (ConfigOf()).
struct ActionRecord {
  struct Argument {
    std::string name;
    std::string type;
    bool operator==(const Argument&) const = default;
  };
  int64_t id = 0;    ///< from 1 in the order of storing; 0: not stored
  std::string name;  ///< its symbol
  std::vector<Argument> arguments;
  std::vector<std::string> agents;  ///< person, robot
  std::string undoes;  ///< name of the action that it takes back; empty: none
  std::string sec;     ///< how it is recognised; empty: never
  std::string rules;   ///< what it does
  std::string robot;   ///< what a robot needs and does besides
  std::string skill;   ///< how an arm does it; empty: no arm can
  std::string skill_settings;  ///< section of the task's skills.yaml
  bool operator==(const ActionRecord&) const = default;
};

}  // namespace cell::library
