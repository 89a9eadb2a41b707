#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/message.h"

namespace cell::cli {

/// Tells what happens in a cell in plain words: key frames, recognised actions,
/// predicates that changed, the plan, what arms do, alerts. Pure: messages in
/// canonical order in, lines out.
class Narrator {
 public:
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

  std::map<std::pair<std::string, std::string>, int8_t> relations_;
  std::map<std::string, int8_t> literals_;
  std::string hold_reason_;  // last told
};

}  // namespace cell::cli
