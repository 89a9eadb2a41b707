#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// A part to be put to a site, whether or not that works.
struct Attempt {
  const PlacementRule* rule = nullptr;
  std::string part;
  std::string site;
  /// Where the part lay before, and where it is put back.
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
};

/// What a person says of an attempt at which the part did not seat.
struct FailedAttempt {
  Attempt attempt;
  double duration = 0;  ///< [s]
};

/// A person who tries out what works: puts parts to sites in any order, leaves
/// some of those that seat there for the next attempts, and takes all of them
/// back in the end. A value.
class Explorer {
 public:
  /// A number of attempts is to be made.
  void Begin(int num_attempts) { num_left_ = num_attempts; }
  /// Attempts are to be made, or parts to be taken back.
  bool is_busy() const { return num_left_ > 0 || !seated_.empty(); }

  /// Time goes on by `dt` [s].
  void Update(double dt) { time_ += dt; }
  /// The hands are idle: what came of the attempt that was under way.
  void Book(const World& world);
  /// Once for each attempt that failed.
  std::optional<FailedAttempt> TakeFailure();

  /// The part to be taken back next, if it should be now.
  std::optional<Attempt> ToTakeBack(std::mt19937_64& random) const;
  /// It is on its way to the table.
  void TakenBack() { seated_.pop_back(); }
  /// One of the candidates, of each rule equally often; nullopt, and no attempt
  /// is left, if there are none.
  std::optional<Attempt> Next(const std::vector<Attempt>& candidates,
                              std::mt19937_64& random);
  bool IsSeatedByAttempt(const std::string& part) const;

 private:
  int num_left_ = 0;
  double time_ = 0;  // [s] since the latest attempt began
  std::optional<Attempt> running_;
  std::vector<Attempt> seated_;  // the latest last
  std::optional<FailedAttempt> failure_;
};

/// The sites at which a part of the rule may be tried: those of all rules that
/// the person calls the same, on parts that do not lie on the table. Screwed
/// joints are left out: no hand action takes them apart.
std::vector<std::string> SitesToTry(
    const PlacementRule& rule, const Demonstrations& demonstrations,
    const std::vector<std::string>& parts_in_place, const World& world);

}  // namespace cell::vtb
