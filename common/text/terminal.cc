#include "common/text/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace cell {
namespace {

std::string_view Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool TakesTerminalCodes(int descriptor) {
  const std::string_view terminal = Environment("TERM");
  return isatty(descriptor) == 1 && !terminal.empty() && terminal != "dumb" &&
         Environment("NO_COLOR").empty();
}

int TerminalColumns(int descriptor) {
  const std::string_view text = Environment("COLUMNS");
  int columns = 0;
  const auto result =
      std::from_chars(text.data(), text.data() + text.size(), columns);
  const bool is_number =
      result.ec == std::errc() && result.ptr == text.data() + text.size();
  if (is_number && columns > 0) return columns;
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    return size.ws_col;
  }
  return 80;
}

}  // namespace cell
