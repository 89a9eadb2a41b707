#include "services/cell/logs/log_finding.h"

#include <fmt/format.h>

#include "common/text/printable.h"

namespace cell::cli {

std::string ToString(const LogFinding& finding) {
  std::string text;
  if (!finding.file.empty()) {
    text += fmt::format("{} byte {} ({} bytes): ", finding.file, finding.offset,
                        finding.length);
  }
  if (finding.tick >= 0) text += fmt::format("tick {}: ", finding.tick);
  if (!finding.channel.empty()) text += finding.channel + ": ";
  return Printable(text + finding.text);
}

}  // namespace cell::cli
