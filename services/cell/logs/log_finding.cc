#include "services/cell/logs/log_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/text/printable.h"

namespace cell::cli {
namespace {

constexpr size_t kMaxRow = 20;

bool IsAtPlaceOf(const LogFinding& a, const LogFinding& b) {
  return a.offset >= 0 && a.file == b.file && a.offset == b.offset;
}

bool IsRightAfter(const LogFinding& a, const LogFinding& b) {
  return b.offset >= 0 && a.file == b.file && a.offset == b.offset + b.length;
}

void MergeByPlace(std::vector<LogFinding>* findings) {
  std::vector<LogFinding> merged;
  for (LogFinding& finding : *findings) {
    if (!merged.empty() && IsAtPlaceOf(finding, merged.back())) {
      merged.back().text += "; " + finding.text;
    } else {
      merged.push_back(std::move(finding));
    }
  }
  *findings = std::move(merged);
}

}  // namespace

std::vector<LogFinding> ByPlace(std::vector<LogFinding> findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const LogFinding& a, const LogFinding& b) {
                     return std::tie(a.file, a.offset) <
                            std::tie(b.file, b.offset);
                   });
  MergeByPlace(&findings);
  std::vector<LogFinding> folded;
  for (size_t begin = 0; begin < findings.size();) {
    size_t end = begin + 1;
    while (end < findings.size() &&
           IsRightAfter(findings[end], findings[end - 1])) {
      ++end;
    }
    const size_t num_told = end - begin > kMaxRow ? 1 : end - begin;
    for (size_t i = begin; i < begin + num_told; ++i) {
      folded.push_back(std::move(findings[i]));
    }
    if (num_told < end - begin) {
      folded.back().text += fmt::format(
          "; the {} events after it, up to byte {}, have errors as well",
          end - begin - 1, findings[end - 1].offset + findings[end - 1].length);
    }
    begin = end;
  }
  return folded;
}

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
