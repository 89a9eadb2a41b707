#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cell/truth_action_t.hpp"
#include "common/parts/part_table.h"
#include "services/vtb/script.h"

namespace cell::cli {

/// How far a person is with a task, by the ground truth of what the person did
/// and by the order that the task's demonstrators.yaml states. Knows nothing of
/// the rules that the cell plans with, so that these can be judged by it.
///
/// All parts are to be placed. A part that was placed before another which has
/// to come first has to be taken out again; a part that lies down has to be
/// raised. A part that lies over a site and is not seated has to be taken away,
/// which is no action of the task.
class TrueProgress {
 public:
  /// `demonstrations` must outlive this object. No part is placed yet.
  TrueProgress(const vtb::Demonstrations& demonstrations,
               const PartTable& parts);

  void Update(const truth_action_t& action);
  /// Least number of actions to the goal; nullopt if a part that is needed is
  /// out of the workspace, or jammed over a site: a dead end.
  std::optional<int> NumLeft() const;

 private:
  struct Placement {
    const vtb::PlacementRule* rule;
    std::string site;
    std::string part = {};  // empty: open
  };

  Placement* FindSite(const std::string& site);
  bool IsPlaced(const std::string& part) const;
  /// Open, or to be taken out again, by index.
  std::vector<bool> NotInPlace() const;

  std::vector<Placement> placements_;
  std::map<std::string, std::vector<std::string>> parts_of_;  // by type
  std::set<std::string> lying_;
  std::set<std::string> outside_;  // of the workspace
  std::set<std::string> jammed_;   // over a site, not seated
};

/// How many sites of each type stay empty if all is placed that can be without
/// these parts, in the order of demonstrators.yaml; types without any are left
/// out.
std::map<std::string, int> EmptySitesWithout(
    const std::set<std::string>& missing_parts,
    const vtb::Demonstrations& demonstrations, const PartTable& parts);

}  // namespace cell::cli
