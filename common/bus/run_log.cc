#include "common/bus/run_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/decode.h"
#include "common/bus/event_log.h"
#include "common/bus/manifest.h"

namespace cell {
namespace {

// Of ".07" 7: lcm-logger writes at least two digits.
std::optional<int64_t> PartNumber(const std::string& suffix) {
  constexpr size_t kMaxDigits = 9;
  const bool is_number =
      suffix.size() > 2 && suffix.size() <= 1 + kMaxDigits &&
      suffix.find_first_not_of("0123456789", 1) == std::string::npos;
  if (!is_number) return std::nullopt;
  return std::stoll(suffix.substr(1));
}

}  // namespace

std::vector<std::filesystem::path> LogsOf(
    const std::filesystem::path& run_dir) {
  std::vector<std::filesystem::path> logs;
  if (std::filesystem::is_directory(run_dir)) {
    for (const auto& entry : std::filesystem::directory_iterator(run_dir)) {
      if (entry.path().extension() == ".lcmlog") logs.push_back(entry.path());
    }
  }
  std::sort(logs.begin(), logs.end());
  return logs;
}

std::vector<std::filesystem::path> LoggerPartsOf(
    const std::filesystem::path& folder) {
  std::map<int64_t, std::filesystem::path> parts;
  if (!std::filesystem::is_directory(folder)) return {};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    const std::string suffix = path.extension().string();
    const auto number = PartNumber(suffix);
    if (!number || !entry.is_regular_file()) continue;
    if (!parts.empty() && parts.begin()->second.stem() != path.stem()) {
      throw std::runtime_error(fmt::format(
          "{}: holds the parts of two recordings, {} and {}; name one file, or "
          "give each a folder of its own",
          folder.string(), parts.begin()->second.filename().string(),
          path.filename().string()));
    }
    parts[*number] = path;
  }
  std::vector<std::filesystem::path> logs;
  for (const auto& [number, path] : parts) logs.push_back(path);
  return logs;
}

std::vector<std::filesystem::path> RequireLogsOf(
    const std::filesystem::path& run_dir) {
  auto logs = LogsOf(run_dir);
  if (logs.empty()) logs = LoggerPartsOf(run_dir);
  if (logs.empty()) {
    throw std::runtime_error(run_dir.string() +
                             ": no *.lcmlog in it, nor parts of a recording of "
                             "lcm-logger (NAME.00, NAME.01, ...); is it a run "
                             "folder?");
  }
  return logs;
}

RunLog RunLog::Load(const std::filesystem::path& run_dir) {
  return Load(RequireLogsOf(run_dir));
}

RunLog RunLog::Load(const std::vector<std::filesystem::path>& logs) {
  RunLog run;
  for (const auto& log : logs) run.Read(log);
  std::erase_if(run.ticks_, [&](const auto& entry) {
    const bool has_manifest = entry.second.has_manifest;
    if (!has_manifest) {
      run.problems_.push_back(
          fmt::format("tick {}: its TICK is missing", entry.first));
    }
    return !has_manifest;
  });
  if (run.ticks_.empty()) {
    throw std::runtime_error(logs.front().string() + ": holds no TICK");
  }
  run.Check();
  return run;
}

void RunLog::Read(const std::filesystem::path& log) {
  EventLogReader reader(log);
  reader.Finish();
  while (auto event = reader.Next()) {
    auto message = MessageFromWire(event->channel, std::move(event->bytes));
    if (!message) continue;  // another program's, e.g. LCM_SELF_TEST
    Tick& tick = ticks_[message->tick];
    if (message->channel != kTickChannel) {
      tick.messages.push_back(*message);
      continue;
    }
    auto manifest = Decode<tick_t>(*message);
    if (manifest && IsSound(manifest->flows)) {
      tick.manifest = *std::move(manifest);
      tick.has_manifest = true;
    }
  }
  for (const auto& range : reader.corrupt_ranges()) {
    problems_.push_back(fmt::format("{}: {} bytes from byte {} on are damaged",
                                    log.string(), range.length, range.offset));
  }
}

void RunLog::Check() {
  const int32_t begin = ticks_.begin()->first;
  if (begin > 0) {
    problems_.push_back(fmt::format("ticks 0 to {} are missing", begin - 1));
  }
  const Tick* previous = nullptr;
  for (auto& [k, tick] : ticks_) {
    std::stable_sort(tick.messages.begin(), tick.messages.end(), OrderedBefore);
    const bool has_previous =
        previous != nullptr && previous->manifest.header.tick == k - 1;
    if (previous != nullptr && !has_previous) {
      problems_.push_back(fmt::format("ticks {} to {} are missing",
                                      previous->manifest.header.tick + 1,
                                      k - 1));
    }
    if (has_previous && TickMessage(previous->manifest).digest !=
                            tick.manifest.previous_digest) {
      problems_.push_back(fmt::format(
          "tick {}: TICK is not the one that TICK {} refers to", k - 1, k));
    }
    // Flows name the services' messages of the tick before, and the clock's;
    // a recorder that joins after a gap has received neither.
    for (const MessageId& id : MessagesIn(tick.manifest.flows)) {
      if (!has_previous && (k > 0 || id.sender != 0)) break;
      const Tick* of = id.sender == 0 ? &tick : previous;
      const auto match = std::find_if(
          of->messages.begin(), of->messages.end(), [&](const Message& m) {
            return m.channel == id.channel && m.sender == id.sender &&
                   m.seq == id.seq && m.digest == id.digest;
          });
      if (match == of->messages.end()) {
        problems_.push_back(fmt::format("tick {}: {} is missing or damaged",
                                        of->manifest.header.tick,
                                        ToString(id)));
      }
    }
    previous = &tick;
  }
}

}  // namespace cell
