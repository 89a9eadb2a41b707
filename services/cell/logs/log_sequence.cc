#include "services/cell/logs/log_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "common/bus/bus.h"
#include "services/cell/logs/log_frames.h"

namespace cell::cli {
namespace {

/// More jumps, or steps back, are reported in one line.
constexpr size_t kMaxOfAKind = 20;
constexpr size_t kMaxSilences = 3;
constexpr int64_t kLeastSilenceUs = 1'000'000;
constexpr int64_t kSilenceFactor = 100;

std::vector<LogFinding> Few(std::vector<LogFinding> findings,
                            const char* what) {
  if (findings.size() <= kMaxOfAKind) return findings;
  findings.front().text += fmt::format("; {} {}", findings.size() - 1, what);
  findings.resize(1);
  return findings;
}

// What follows an entry in its file; nullptr after the last.
const LogEntry* Next(const LogIndex& index, size_t i) {
  const auto& entries = index.entries;
  const bool has_next =
      i + 1 < entries.size() && entries[i + 1].file == entries[i].file;
  return has_next ? &entries[i + 1] : nullptr;
}

bool IsAsRecorded(const LogEntry& entry) {
  return !entry.is_short &&
         entry.utime == int64_t{entry.message.tick} * kTickUs;
}

std::string JumpText(int64_t number, int64_t expected) {
  return number > expected
             ? fmt::format(
                   "its number is {}, should be {}: the events between are "
                   "missing, or it was inserted here",
                   number, expected)
             : fmt::format("its number is {}, should be {}", number, expected);
}

// [us] Half of the events come within this time of the one before.
int64_t MedianStep(const LogIndex& index) {
  std::vector<int64_t> steps;
  for (size_t i = 1; i < index.entries.size(); ++i) {
    steps.push_back(index.entries[i].utime - index.entries[i - 1].utime);
  }
  const auto middle =
      steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

std::vector<LogFinding> FindOddNumbers(const LogIndex& index,
                                       bool is_canonical) {
  std::vector<LogFinding> findings;
  int64_t expected = 0;
  int64_t end = 0;  // [bytes] of the entry before
  for (size_t i = 0; i < index.entries.size(); ++i) {
    const LogEntry& entry = index.entries[i];
    if (i > 0 && index.entries[i - 1].file != entry.file) expected = end = 0;
    if (entry.offset != end)
      expected = entry.number;  // corrupt: reported already
    end = entry.offset + entry.size;
    const LogEntry* next = Next(index, i);
    if (entry.number == expected) {
      // Of two with one number the recorder's is the one with its stamp.
      const bool is_put_here = is_canonical && next != nullptr &&
                               next->number == expected && !IsAsRecorded(entry);
      if (!is_put_here) ++expected;
      continue;
    }
    findings.push_back(FindingAt(index, i, JumpText(entry.number, expected)));
    const bool goes_on = next != nullptr && next->number == expected;
    if (!goes_on) expected = entry.number + 1;
  }
  return Few(std::move(findings), "other numbers jump as well");
}

std::vector<LogFinding> FindOddStamps(const LogIndex& index,
                                      const StampRules& rules) {
  const auto& entries = index.entries;
  if (entries.size() < 2) return {};
  const int64_t median = MedianStep(index);
  const int64_t silence = std::max(kLeastSilenceUs, kSilenceFactor * median);
  std::vector<LogFinding> backward, silences;
  for (size_t i = 1; i < entries.size(); ++i) {
    const int64_t step = entries[i].utime - entries[i - 1].utime;
    if (step < -rules.backward_us) {
      backward.push_back(
          FindingAt(index, i,
                    fmt::format("time runs backwards: it is {:.6f} s earlier "
                                "than the event before it",
                                -1e-6 * static_cast<double>(step))));
    } else if (step > silence) {
      silences.push_back(
          FindingAt(index, i,
                    fmt::format("no event for {:.3f} s before it; the median "
                                "interval is {:.3f} s",
                                1e-6 * static_cast<double>(step),
                                1e-6 * static_cast<double>(median))));
    }
  }
  auto findings = Few(std::move(backward), "other events are earlier as well");
  if (rules.has_silences && silences.size() <= kMaxSilences) {
    findings.insert(findings.end(), silences.begin(), silences.end());
  }
  return findings;
}

}  // namespace cell::cli
