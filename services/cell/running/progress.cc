#include "services/cell/running/progress.h"

#include <unistd.h>

#include <iostream>

#include "common/text/printable.h"
#include "common/text/printable_output.h"
#include "common/text/terminal.h"

namespace cell::cli {
namespace {

constexpr char kClearLine[] = "\r\x1b[K";

}  // namespace

Progress::Progress()
    : is_terminal_(TakesTerminalCodes(STDERR_FILENO)),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  Clear();
}

void Progress::Show(const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  is_shown_ = true;
  WriteTerminalCode(std::cerr, kClearLine);
  // A line that wraps is not cleared whole.
  const int columns = TerminalColumns(STDERR_FILENO);
  std::cerr << PrintableName(text, static_cast<size_t>(columns)) << std::flush;
}

void Progress::Clear() {
  if (is_shown_) WriteTerminalCode(std::cerr, kClearLine);
  is_shown_ = false;
}

double Progress::ElapsedSeconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                       start_)
      .count();
}

}  // namespace cell::cli
