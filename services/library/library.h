#pragma once

#include <memory>
#include <span>
#include <string>

#include "cell/action_record_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/library_request_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "services/library/action_store.h"
#include "services/library/record_check.h"
#include "services/library/record_edits.h"

namespace cell::library {

/// STORE_REQUEST -> STORED, once the store keeps it, and ACTION_RECORD. The
/// latest records of all actions at an episode's start, when this incarnation
/// joins a running one, and on LIBRARY_REQUEST. An operator changes records by
/// COMMAND_LIBRARY; what has changed follows on ACTION_RECORD. The content of
/// the store when a run begins is an input of this service.
///
/// After a death the next incarnation removes what was stored in ticks that the
/// dead one did not answer: no service received an answer, and in one process
/// it would not have happened.
class Library final : public Service {
 public:
  /// `bus` must outlive this object.
  Library(Bus& bus, std::shared_ptr<ActionStore> store, RecordCheck check);

 private:
  bool OnTick(std::span<const uint8_t> bytes);
  bool OnEpisode(const episode_t& message);
  CommandAnswer OnRequest(const library_request_t& message);
  CommandAnswer OnCommand(const command_library_t& message);
  Result<RecordEdits::Records> EditOf(const command_library_t& message) const;
  void OnStoreRequest(const action_record_t& message);
  void Publish(const ActionRecord& record, int64_t utime);
  void PublishAll(int64_t utime);

  Bus& bus_;
  EpisodeGate episode_;
  std::shared_ptr<ActionStore> store_;
  RecordCheck check_;
  bool has_joined_ = false;
};

/// `store` outlives the incarnations that share it.
std::unique_ptr<Service> MakeLibrary(Bus& bus, const Deployment& deployment,
                                     std::shared_ptr<ActionStore> store);

}  // namespace cell::library
