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

  std::vector<std::string> Describe(const Message& message);

 private:
  std::vector<std::string> DescribeKeyFrame(const Message& message);
  std::vector<std::string> DescribeAction(const Message& message);
  std::vector<std::string> DescribePredicates(const Message& message);
  std::vector<std::string> DescribePlan(const Message& message);
  std::vector<std::string> DescribeAlert(const Message& message);
  std::vector<std::string> DescribeAnswer(const Message& message);
  std::vector<std::string> DescribeEpisode(const Message& message);
  std::vector<std::string> DescribeRequest(const Message& message);
  std::vector<std::string> DescribeResult(const Message& message);
  std::vector<std::string> DescribeExecution(const Message& message);
  std::vector<std::string> DescribeMode(const Message& message);

  bool is_verbose_;
  std::map<std::pair<std::string, std::string>, int8_t> relations_;
  std::map<std::string, int8_t> literals_;
  std::string hold_reason_;   // last printed
  std::string plan_summary_;  // last printed
};

}  // namespace cell::cli
