#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cell::cli {

/// How fast a domain is learned without a teacher.
struct LearningCurveOptions {
  std::string domain_file;
  std::string learn_file;               ///< the problem to learn in
  std::vector<std::string> test_files;  ///< the problems to solve
  int num_actions = 110;
  int interval = 5;  ///< actions between two tests
  int runs = 10;
  uint64_t seed = 1;
  int jobs = 2;
  std::string rows_file;  ///< empty: runs/eval-...
  std::string csv_file;
  bool is_resumed = false;
};

/// Learns with each seed, tests, and prints the curve. Returns the exit code.
/// @throws std::runtime_error, ppddl::PpddlError naming the file
int EvalLearningCurve(const LearningCurveOptions& options);

}  // namespace cell::cli
