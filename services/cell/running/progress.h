#pragma once

#include <chrono>
#include <string>

namespace cell::cli {

/// One line on a terminal that shows the progress of long work; silent if the
/// output is no terminal. Device adapter.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `text` instead of the line before, at most ten times a second.
  void Show(const std::string& text);
  /// Clears the line, so that other output may follow.
  void Clear();
  double ElapsedSeconds() const;

 private:
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace cell::cli
