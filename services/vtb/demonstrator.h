#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/explorer.h"
#include "services/vtb/hand_actor.h"
#include "services/vtb/placement_sampler.h"
#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// A scripted person who shows the cell a task: decides what each hand does
/// next. A value: a copy, with a copy of the world's snapshot, goes on in the
/// same way.
class Demonstrator {
 public:
  /// Puts the parts of `world` where the script begins and stands ready.
  /// @throws std::invalid_argument if there is no such script.
  Demonstrator(std::shared_ptr<const Demonstrations> demonstrations,
               const std::string& script, uint64_t seed, World& world);

  /// One tick: moves the hands of `world` for the coming `dt` [s].
  void Update(double dt, World& world);

  /// All is done and the hands rest.
  bool is_done() const;
  /// Parts that did not seat in spite of all tries.
  std::vector<std::string> failures() const;
  /// What the person says of an attempt that has failed, once.
  std::optional<FailedAttempt> TakeFailedAttempt() {
    return explorer_.TakeFailure();
  }

 private:
  struct Placement {
    const PlacementRule* rule;
    std::string site;
    enum class State { kOpen, kClaimed, kDone } state = State::kOpen;
    std::string part;  // unless it is open
  };
  enum class EventKind {
    kTakeBack,
    kUnknownMove,
    kTooEarly,
    kTryOut,
    kLayOutside,
    kLayDown
  };
  struct Event {
    EventKind kind;
    int when;  // placements done before it
  };
  struct Hand {
    HandActor actor;
    int placement = -1;       // that it works on
    bool is_fetched = false;  // it holds the part at its rest
  };

  void ScatterParts(World& world);
  void PlanEvents();
  void BookFinished(const World& world);
  void Decide(World& world);
  void StartEvent(World& world);
  bool Start(EventKind kind, World& world);
  bool TakeBack(const std::vector<size_t>& candidates, World& world);
  bool MoveAside(World& world);
  bool PlaceTooEarly(World& world);
  void Explore(World& world);
  std::vector<Attempt> PossibleAttempts(const World& world) const;
  bool LayOutside(World& world);
  bool LayDown(World& world);
  /// One of the free parts of these types; nothing if there is none.
  std::optional<std::string> AnyFreePart(const std::vector<std::string>& types,
                                         const World& world);
  void PlaceNext(Hand& hand, World& world);
  bool StartPlacing(Hand& hand, size_t index, bool only_fetch, World& world);
  void CarryOn(Hand& hand, World& world);
  void PutOnTable(const std::string& part, const std::string& from_site,
                  const Target& target);

  bool AreHandsIdle() const;
  int NumDone() const;
  bool IsReady(const Placement& placement, bool soon) const;
  bool IsLoose(const Placement& placement) const;
  bool IsWayFree(const HandActor& actor, const World& world) const;
  bool WouldSpoilMistake(const Placement& placement, const World& world) const;
  std::optional<Eigen::Isometry3d> PlaceFor(const std::string& part,
                                            double min_way, const World& world);
  std::vector<std::string> FreeParts(const std::string& type,
                                     const World& world) const;
  template <class T>
  const T& AnyOf(const std::vector<T>& items) {
    return items[std::uniform_int_distribution<size_t>(
        0, items.size() - 1)(random_)];
  }

  std::shared_ptr<const Demonstrations> demonstrations_;
  const Script* script_;
  std::shared_ptr<const PlacementSampler> sampler_;
  std::mt19937_64 random_;
  std::vector<Placement> placements_;
  std::vector<Event> events_;  // to come, the next first
  std::vector<Hand> hands_;
  std::vector<size_t> to_correct_;  // placements done too early
  Explorer explorer_;
  double pause_ = 0;      // [s] until the next decision
  bool is_over_ = false;  // nothing more is begun
};

}  // namespace cell::vtb
