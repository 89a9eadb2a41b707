#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "cell/action_record_t.hpp"
#include "cell/command_library_t.hpp"
#include "cell/experience_t.hpp"
#include "cell/library_request_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "services/library/action_store.h"
#include "services/library/experience_check.h"
#include "services/library/record_check.h"
#include "services/library/record_edits.h"

namespace cell::library {

/// STORE_REQUEST -> STORED, once the store keeps it, and ACTION_RECORD;
/// EXPERIENCE_REQUEST -> STORED and EXPERIENCE. The latest records of all
/// actions at an episode's start, when this incarnation joins a running one,
/// and on LIBRARY_REQUEST; after them the experiences, kToldPerTick in a tick.
/// Left out are those of actions that were removed, and those with objects that
/// the task does not have. An operator changes the content by COMMAND_LIBRARY;
/// what has changed follows on ACTION_RECORD and EXPERIENCE. The content of the
/// store when a run begins is an input of this service.
///
/// After a death the next incarnation removes what was stored in ticks that the
/// dead one did not answer: no service received an answer, and in one process
/// it would not have happened.
class Library final : public Service {
 public:
  /// About half a megabyte of messages.
  static constexpr int64_t kToldPerTick = 64;

  /// `bus` must outlive this object.
  Library(Bus& bus, std::shared_ptr<ActionStore> store, RecordCheck check);

 private:
  bool OnTick(std::span<const uint8_t> bytes);
  bool OnEpisode(const episode_t& message);
  CommandAnswer OnRequest(const library_request_t& message);
  CommandAnswer OnCommand(const command_library_t& message);
  Result<StoreEdit> EditOf(const command_library_t& message) const;
  void OnStoreRequest(const action_record_t& message);
  void Publish(const ActionRecord& record, int64_t utime);
  void PublishAll(int64_t utime);
  void OnExperienceRequest(const experience_t& message);
  void Publish(const ExperienceRecord& experience, int64_t utime);
  void PublishRemoval(int64_t experience, int64_t utime);
  void PublishExperiences();
  bool IsTold(const ExperienceRecord& experience) const;

  Bus& bus_;
  EpisodeGate episode_;
  std::shared_ptr<ActionStore> store_;
  RecordCheck check_;
  ExperienceCheck experience_check_;
  std::string demonstration_;         // of the episode
  std::optional<int64_t> next_told_;  // id of an experience; nothing: all are
  int64_t told_utime_ = 0;            // of what asked for them
  bool has_joined_ = false;
};

/// `store` outlives the incarnations that share it.
std::unique_ptr<Service> MakeLibrary(Bus& bus, const Deployment& deployment,
                                     std::shared_ptr<ActionStore> store);

}  // namespace cell::library
