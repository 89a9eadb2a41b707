#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// Something a person did to a part, from gripping it to letting go.
struct LabeledAction {
  enum class Kind { kPlaced, kTakenBack, kMoved, kTipped };
  enum class Mistake { kNone, kOutOfOrder, kOutOfWorkspace, kNotSeated };
  Kind kind = Kind::kMoved;
  Mistake mistake = Mistake::kNone;
  std::string part;
  std::string site;  ///< where it was placed, or taken back from
  std::string hand;  ///< that held it first
  int64_t pick_utime = 0;
  int64_t place_utime = 0;
};

/// Labels the actions in the world: ground truth for scorers. It
/// looks at grips and seats alone, not at what the person meant to do. A part
/// that goes from one site to another is two actions; one that comes to stand
/// where it stood is none.
class ActionLabeler {
 public:
  explicit ActionLabeler(std::shared_ptr<const Demonstrations> demonstrations)
      : demonstrations_(std::move(demonstrations)) {}

  /// To be called once a tick; the actions that are done and have settled.
  std::vector<LabeledAction> Update(int64_t utime, const World& world);

 private:
  struct Grip {
    std::string hand;
    int64_t pick_utime = 0;
    std::optional<std::string> from_site;
    Eigen::Isometry3d X_WO_pick = Eigen::Isometry3d::Identity();
    std::optional<int64_t> release_utime;  // while it settles
  };

  void NoteGrips(int64_t utime, const World& world);
  std::vector<LabeledAction> Conclude(const std::string& part, const Grip& grip,
                                      const World& world) const;
  const PlacementRule* RuleOf(const Part& part, const Site& site) const;
  /// The first site for which accept(where the part is in the site's frame,
  /// when it is seated) holds.
  template <class Accept>
  std::optional<std::string> FindSite(const std::string& part,
                                      const World& world, Accept accept) const;
  std::optional<std::string> SeatOf(const std::string& part,
                                    const World& world) const;
  bool IsBesideItsSeat(const std::string& part, const World& world) const;
  bool IsTooEarly(const Part& part, const std::string& site,
                  const World& world) const;

  std::shared_ptr<const Demonstrations> demonstrations_;
  std::map<std::string, Grip> grips_;  // by part
};

}  // namespace cell::vtb
