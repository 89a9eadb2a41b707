#include "services/cell/logs/canonical_log.h"

#include <map>
#include <utility>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/event_log.h"
#include "common/files/draft.h"

namespace cell::cli {
namespace {

// Puts payloads, which come in the order of the log, into that of the audit.
class OrderedWriter {
 public:
  OrderedWriter(const LogAudit& audit, const std::filesystem::path& out)
      : audit_(audit), writer_(out) {
    for (size_t i = 0; i < audit.kept.size(); ++i) {
      if (audit.kept[i].entry) rank_of_[*audit.kept[i].entry] = i;
    }
  }

  void Put(size_t entry, const Bytes& bytes) {
    const auto rank = rank_of_.find(entry);
    if (rank == rank_of_.end()) return;
    if (!audit_.kept[rank->second].bytes) waiting_[rank->second] = bytes;
    WriteDue();
  }

  void Finish() {
    WriteDue();
    writer_.Close();
  }

 private:
  // Up to the first one that has not come yet.
  void WriteDue() {
    for (; next_ < audit_.kept.size(); ++next_) {
      const KeptEvent& event = audit_.kept[next_];
      const auto waiting = waiting_.find(next_);
      if (!event.bytes && waiting == waiting_.end()) return;
      writer_.Write(int64_t{event.tick} * kTickUs, event.channel,
                    event.bytes ? *event.bytes : waiting->second);
      if (waiting != waiting_.end()) waiting_.erase(waiting);
    }
  }

  const LogAudit& audit_;
  EventLogWriter writer_;
  std::map<size_t, size_t> rank_of_;  // entry -> place among the kept
  std::map<size_t, Bytes> waiting_;   // by place
  size_t next_ = 0;
};

int64_t Write(const LogIndex& index, const LogAudit& audit,
              const std::filesystem::path& out) {
  if (audit.manifests.empty()) {
    EventLogWriter writer(out);
    ReadPayloads(index, [&](size_t entry, const Bytes& bytes) {
      writer.Write(index.entries[entry].utime,
                   index.entries[entry].message.channel, bytes);
    });
    writer.Close();
    return static_cast<int64_t>(index.entries.size());
  }
  OrderedWriter writer(audit, out);
  ReadPayloads(index, [&](size_t entry, const Bytes& bytes) {
    writer.Put(entry, bytes);
  });
  writer.Finish();
  return static_cast<int64_t>(audit.kept.size());
}

}  // namespace

int64_t WriteCanonicalLog(const LogIndex& index, const LogAudit& audit,
                          const std::filesystem::path& out) {
  constexpr char kAdvice[] = "choose another --out or remove it";
  RequireFree(out, kAdvice);
  Draft draft(out);
  const int64_t num = Write(index, audit, draft.path());
  draft.PutNew(kAdvice);
  return num;
}

}  // namespace cell::cli
