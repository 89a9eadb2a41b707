#include "services/cell/logs/log_audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <set>
#include <tuple>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/manifest.h"
#include "services/cell/logs/foreign_types.h"
#include "services/cell/logs/log_frames.h"

namespace cell::cli {
namespace {

bool IsOfProtocol(const LogEntry& entry) {
  const std::string& channel = entry.message.channel;
  return entry.is_short || channel == kAckChannel || channel == kHelloChannel ||
         channel == kHealthChannel;
}

// Sim stamps: most of them, for some may be damaged.
bool IsCanonical(const LogIndex& index) {
  int64_t num = 0;
  for (const LogEntry& entry : index.entries) {
    num += entry.utime == int64_t{entry.message.tick} * kTickUs ? 1 : -1;
  }
  return num > 0;
}

class Auditor {
 public:
  explicit Auditor(const LogIndex& index) : index_(index) {
    audit_.is_canonical = IsCanonical(index);
    audit_.manifests = FindManifests(index);
    for (size_t i = 0; i < index.entries.size(); ++i) {
      const LogEntry& entry = index.entries[i];
      if (IsOfProtocol(entry)) continue;
      heard_.insert(entry.message.tick);
      if (entry.is_tick) continue;
      const int32_t tick = entry.message.tick;
      named_by_[entry.message.sender == 0 || tick == INT32_MAX ? tick
                                                               : tick + 1]
          .push_back(i);
    }
  }

  LogAudit Audit() {
    audit_.findings = FindOddFrames(index_, audit_.is_canonical);
    if (!audit_.manifests.empty()) {
      FindLostTicks();
      for (const auto& [tick, link] : audit_.manifests) CheckTick(tick, link);
      KeepUnproved();
      FindOddTicks();
    }
    for (LogFinding& finding :
         FindForeignTypes(index_, !audit_.manifests.empty())) {
      audit_.findings.push_back(std::move(finding));
    }
    std::sort(audit_.kept.begin(), audit_.kept.end(),
              [](const KeptEvent& a, const KeptEvent& b) {
                return std::tie(a.tick, a.channel, a.sender, a.seq) <
                       std::tie(b.tick, b.channel, b.sender, b.seq);
              });
    return std::move(audit_);
  }

 private:
  const LogEntry& At(size_t i) const { return index_.entries[i]; }
  void Report(int32_t tick, const std::string& channel, std::string text) {
    audit_.findings.push_back({"", -1, 0, tick, channel, std::move(text)});
  }
  void ReportEntry(size_t i, std::string text) {
    audit_.findings.push_back(FindingAt(index_, i, std::move(text)));
  }

  void FindLostTicks() {
    const auto& manifests = audit_.manifests;
    int32_t expected = manifests.begin()->first;
    for (const auto& [tick, link] : manifests) {
      if (tick == expected + 1) {
        Report(expected, kTickChannel, "is lost: its messages are unproved");
      } else if (tick > expected) {
        Report(expected, "",
               fmt::format("ticks {} to {} are lost", expected, tick - 1));
      }
      if (!link.entry) {
        Report(tick, kTickChannel,
               "was lost or damaged; it follows from its messages");
      }
      expected = tick + 1;
    }
    const auto& [first, first_link] = *manifests.begin();
    if (first > 0) {
      Report(0, "", fmt::format("the log begins with tick {}", first));
    }
    if (manifests.rbegin()->second.tick.is_last == 0) {
      Report(expected - 1, "", "the log ends before the cell's last TICK");
    }
  }

  // All that the TICK names, and nothing else.
  void CheckTick(int32_t tick, const ManifestLink& link) {
    CheckChain(tick, link);
    Keep(link.message, link.entry, link.message.bytes);
    std::vector<size_t> entries = named_by_[tick];
    named_by_.erase(tick);
    for (const MessageId& id : MessagesIn(link.tick.flows)) {
      const auto has_id = [&](size_t i) {
        const Message& m = At(i).message;
        return m.channel == id.channel && m.sender == id.sender &&
               m.seq == id.seq;
      };
      const auto match =
          std::find_if(entries.begin(), entries.end(), [&](size_t i) {
            return has_id(i) && At(i).message.digest == id.digest;
          });
      if (match != entries.end()) {
        if (!IsBeforeFirstTick(At(*match).message.tick)) {
          Keep(At(*match).message, *match, nullptr);
        }
        entries.erase(match);
        continue;
      }
      const auto damaged = std::find_if(entries.begin(), entries.end(), has_id);
      if (damaged != entries.end() && audit_.is_canonical) {
        ReportEntry(
            *damaged,
            fmt::format("sender {} seq {} is damaged: its digest is "
                        "{:016x}, TICK {} names {:016x}",
                        id.sender, id.seq,
                        std::bit_cast<uint64_t>(At(*damaged).message.digest),
                        tick, std::bit_cast<uint64_t>(id.digest)));
        entries.erase(damaged);
      } else if (!IsBeforeTheLog(tick, id.sender)) {
        Report(id.sender == 0 ? tick : tick - 1, id.channel,
               fmt::format("sender {} seq {}, which TICK {} names, is lost",
                           id.sender, id.seq, tick));
      }
    }
    for (const size_t i : entries) Unnamed(i);
  }

  void CheckChain(int32_t tick, const ManifestLink& link) {
    const auto before = audit_.manifests.find(tick - 1);
    if (before != audit_.manifests.end() &&
        before->second.message.digest != link.tick.previous_digest) {
      Report(tick, kTickChannel,
             fmt::format("does not follow TICK {}: one of both is damaged",
                         tick - 1));
    }
  }

  // A recorder that joins hears neither the clock's messages of that tick nor
  // anything older.
  bool IsBeforeTheLog(int32_t tick, int32_t sender) const {
    if (tick == 0 || heard_.contains(tick - 1)) {
      return sender != 0 && IsBeforeFirstTick(tick - 1);
    }
    return true;
  }
  // A recording that began within a tick holds no more than a part of it.
  bool IsBeforeFirstTick(int32_t tick) const {
    return tick < 0 ||
           (!audit_.is_canonical && tick < audit_.manifests.begin()->first);
  }

  void Unnamed(size_t i) {
    if (audit_.is_canonical) {
      ReportEntry(i, fmt::format("sender {} seq {}: no TICK names it",
                                 At(i).message.sender, At(i).message.seq));
    } else {
      ++audit_.num_unnamed;
    }
  }

  // What no TICK can name, for it is lost, is kept; what a cell says after its
  // last TICK is none of the run.
  void KeepUnproved() {
    const auto& [last, last_link] = *audit_.manifests.rbegin();
    for (const auto& [tick, entries] : named_by_) {
      const bool is_of_run =
          tick >= audit_.manifests.begin()->first - 1 &&
          tick <= last + (last_link.tick.is_last != 0 ? 0 : 2);
      for (const size_t i : entries) {
        if (!is_of_run) {
          Unnamed(i);
          continue;
        }
        if (IsBeforeFirstTick(At(i).message.tick)) continue;
        Keep(At(i).message, i, nullptr);
        ++audit_.num_unproved;
      }
    }
  }

  // TICKs that are not those of the chain, and what a canonical log lacks.
  void FindOddTicks() {
    if (!audit_.is_canonical) return;
    for (size_t i = 0; i < index_.entries.size(); ++i) {
      const LogEntry& entry = At(i);
      if (IsOfProtocol(entry)) {
        ReportEntry(i, "does not belong in a cell's log");
        continue;
      }
      if (!entry.is_tick) continue;
      const auto link = audit_.manifests.find(entry.message.tick);
      if (link == audit_.manifests.end() || link->second.entry != i) {
        ReportEntry(i, "is damaged: not the TICK that the next one refers to");
      } else if (entry.message.channel != kTickChannel) {
        ReportEntry(i, "is a TICK by its type: its channel is damaged");
      } else if (*entry.message.bytes != *link->second.message.bytes) {
        ReportEntry(i, "is not as a canonical log has it");
      }
    }
  }

  void Keep(const Message& message, std::optional<size_t> entry,
            std::shared_ptr<const Bytes> bytes) {
    audit_.kept.push_back({message.tick, message.channel, message.sender,
                           message.seq, entry, std::move(bytes)});
  }

  const LogIndex& index_;
  LogAudit audit_;
  std::map<int32_t, std::vector<size_t>> named_by_;  // TICK -> entries
  std::set<int32_t> heard_;  // ticks of which there is an event
};

}  // namespace

LogAudit AuditLog(const LogIndex& index) {
  return Auditor(index).Audit();
}

}  // namespace cell::cli
