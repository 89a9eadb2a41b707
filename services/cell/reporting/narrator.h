#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/message.h"

namespace cell::cli {

/// Tells what happens in a cell in plain words: key frames, recognised actions,
/// predicates that changed, the next step, what arms do, alerts. If it is
/// verbose also the state at the start, and all of each plan. Pure: messages in
/// canonical order in, lines out.
class Narrator {
 public:
  explicit Narrator(bool is_verbose = false) : is_verbose_(is_verbose) {}

  std::vector<std::string> Tell(const Message& message);

 private:
  std::vector<std::string> TellKeyFrame(const Message& message);
  std::vector<std::string> TellAction(const Message& message);
  std::vector<std::string> TellPredicates(const Message& message);
  std::vector<std::string> TellPlan(const Message& message);
  std::vector<std::string> TellAlert(const Message& message);
  std::vector<std::string> TellAnswer(const Message& message);
  std::vector<std::string> TellEpisode(const Message& message);
  std::vector<std::string> TellRequest(const Message& message);
  std::vector<std::string> TellResult(const Message& message);
  std::vector<std::string> TellExecution(const Message& message);
  std::vector<std::string> TellMode(const Message& message);

  bool is_verbose_;
  std::map<std::pair<std::string, std::string>, int8_t> relations_;
  std::map<std::string, int8_t> literals_;
  std::string hold_reason_;   // last told
  std::string plan_summary_;  // last told
};

}  // namespace cell::cli
