#include "services/cell/logs/log_audit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "common/bus/bus.h"
#include "common/bus/manifest.h"
#include "common/bus/roster.h"
#include "services/cell/logs/foreign_types.h"
#include "services/cell/logs/log_frames.h"
#include "services/cell/logs/log_sequence.h"
#include "services/cell/logs/run_extent.h"
#include "services/cell/logs/sequence_gaps.h"

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

constexpr int32_t kMaxLines = 1000;  // for a run of lost TICKs

class Auditor {
 public:
  explicit Auditor(const LogIndex& index) : index_(index) {
    audit_.is_canonical = IsCanonical(index);
    audit_.manifests = FindManifests(index);
    extent_ = RunExtent(index, audit_.manifests, audit_.is_canonical);
    for (size_t i = 0; i < index.entries.size(); ++i) {
      const LogEntry& entry = index.entries[i];
      if (IsOfProtocol(entry)) continue;
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
      audit_.is_complete = true;
      FindLostTicks();
      PutIncarnations();
      for (const auto& [tick, link] : audit_.manifests) CheckTick(tick, link);
      KeepUnproved();
      FindLostSequences();
      FindOddTicks();
    }
    for (LogFinding& finding :
         FindForeignTypes(index_, !audit_.manifests.empty())) {
      audit_.findings.push_back(std::move(finding));
    }
    if (!audit_.is_canonical) {
      // With TICKs, missing messages are found by the manifests.
      std::ranges::move(
          FindOddStamps(index_, {.has_silences = audit_.manifests.empty()}),
          std::back_inserter(audit_.findings));
    }
    if (audit_.manifests.empty()) {
      // Messages of other programs carry no tick.
      for (LogFinding& finding : audit_.findings) finding.tick = -1;
    }
    audit_.findings = ByPlace(std::move(audit_.findings));
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

  void ReportLoss(int32_t tick, const std::string& channel, std::string text) {
    audit_.is_complete = false;
    Report(tick, channel, std::move(text));
  }

  void FindLostTicks() {
    const int32_t begin = extent_.begin();
    const int32_t first = audit_.manifests.begin()->first;
    if (begin > 0) {
      ReportLoss(
          0, "",
          fmt::format(
              "the log begins with tick {}{}", first,
              begin < first ? ", except for parts of earlier ticks" : ""));
    }
    int32_t expected = begin;
    for (const auto& [tick, link] : audit_.manifests) {
      if (tick > expected) {
        ReportLostTicks(expected, tick - 1);
        gaps_.emplace_back(expected, tick - 1);
      }
      if (!link.entry) {
        Report(tick, kTickChannel,
               "was lost or damaged; it was reconstructed from its messages");
      }
      expected = tick + 1;
    }
    if (extent_.is_whole_end()) return;
    if (extent_.end() >= expected) {
      ReportLostTicks(expected, extent_.end());
      gaps_.emplace_back(expected, extent_.end());
    }
    ReportLoss(extent_.end(), "", "the log ends before the cell's last TICK");
  }

  void ReportLostTicks(int32_t first, int32_t last) {
    if (int64_t{last} - first >= kMaxLines) {
      ReportLoss(
          first, kTickChannel,
          fmt::format(
              "all up to tick {} are lost: their messages cannot be verified",
              last));
      return;
    }
    for (int32_t tick = first; tick <= last; ++tick) {
      ReportLoss(tick, kTickChannel,
                 "is lost: its messages cannot be verified");
    }
  }

  void PutIncarnations() {
    if (extent_.begin() == 0) {
      for (const auto& [channel, sender] : extent_.flows()) {
        sequences_.PutBirth(sender, 0);
      }
    }
    for (const auto& [tick, link] : audit_.manifests) {
      for (const joined_t& joined : link.tick.joined) {
        sequences_.PutBirth(joined.sender, tick);
        if (joined.death_tick >= 0) {
          sequences_.PutDeath(joined.sender - kMaxServices, joined.death_tick);
        }
      }
    }
  }

  // All that the TICK names, and nothing else.
  void CheckTick(int32_t tick, const ManifestLink& link) {
    CheckChain(tick, link);
    Keep(link.message, link.entry, link.message.bytes);
    std::vector<size_t> entries = named_by_[tick];
    named_by_.erase(tick);
    for (const MessageId& id : MessagesIn(link.tick.flows)) {
      const int32_t said_in = id.sender == 0 ? tick : tick - 1;
      sequences_.Put(id.channel, id.sender, id.seq, said_in);
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
        if (At(*match).message.tick >= extent_.begin()) {
          Keep(At(*match).message, *match, nullptr);
        }
        entries.erase(match);
        continue;
      }
      const auto damaged = std::find_if(entries.begin(), entries.end(), has_id);
      if (damaged != entries.end() && audit_.is_canonical) {
        audit_.is_complete = false;
        ReportEntry(
            *damaged,
            fmt::format("sender {} seq {} is damaged: its digest is "
                        "{:016x}, TICK {} names {:016x}",
                        id.sender, id.seq,
                        std::bit_cast<uint64_t>(At(*damaged).message.digest),
                        tick, std::bit_cast<uint64_t>(id.digest)));
        entries.erase(damaged);
      } else if (said_in >= extent_.begin()) {
        ReportLoss(said_in, id.channel,
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
             fmt::format("does not follow TICK {}: one of the two is damaged",
                         tick - 1));
    }
  }

  void Unnamed(size_t i) {
    if (audit_.is_canonical) {
      ReportEntry(i, fmt::format("sender {} seq {}: no TICK names it",
                                 At(i).message.sender, At(i).message.seq));
    } else {
      ++audit_.num_unnamed;
    }
  }

  // Keeps messages that no TICK names because it is lost. Messages after the
  // cell's last TICK do not belong to the run, nor do those of a service in the
  // tick in which it died.
  void KeepUnproved() {
    std::set<std::tuple<std::string, int32_t, int32_t, int64_t>> kept;
    for (const auto& [named_in, entries] : named_by_) {
      for (const size_t i : entries) {
        const Message& m = At(i).message;
        if (!extent_.Contains(i, named_in) ||
            sequences_.IsDeadIn(m.sender, m.tick) ||
            !kept.emplace(m.channel, m.sender, m.seq, m.digest).second) {
          Unnamed(i);
          continue;
        }
        Keep(m, i, nullptr);
        ++audit_.num_unproved;
        if (extent_.IsTrusted(i)) {
          sequences_.Put(m.channel, m.sender, m.seq, m.tick);
        }
      }
    }
  }

  // With TICKs, messages may be lost that only they have named.
  void FindLostSequences() {
    if (gaps_.empty() && extent_.is_whole_end()) return;
    for (LogFinding& finding : sequences_.Find()) {
      audit_.is_complete = false;
      audit_.findings.push_back(std::move(finding));
    }
    for (const auto& [first, last] : gaps_) {
      auto ends = sequences_.EndsIn(first, last);
      ends.push_back("or any sender on a channel where it sent nothing else");
      const auto beginnings = sequences_.BeginningsUpTo(last);
      Report(
          first, "",
          fmt::format("messages named only by TICK {}{} may be lost unnoticed "
                      "where no later message of the same channel and sender "
                      "follows. None follows: {}{}{}",
                      first, first == last ? "" : fmt::format(" to {}", last),
                      fmt::join(ends, ", "),
                      beginnings.empty() ? "" : "; none is known before: ",
                      fmt::join(beginnings, ", ")));
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
        ReportEntry(i, "is not in canonical form");
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
  RunExtent extent_;
  std::map<int32_t, std::vector<size_t>> named_by_;  // TICK -> entries
  std::vector<std::pair<int32_t, int32_t>> gaps_;    // lost TICKs: first, last
  SequenceGaps sequences_;
};

}  // namespace

LogAudit AuditLog(const LogIndex& index) {
  return Auditor(index).Audit();
}

}  // namespace cell::cli
