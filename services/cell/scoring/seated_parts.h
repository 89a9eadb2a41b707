#pragma once

#include <map>
#include <set>
#include <string>

#include "services/cell/scoring/pose_history.h"
#include "services/cell/scoring/success_criterion.h"

namespace cell::cli {

/// The part that sits and rests at each site, by the criterion's tolerances,
/// whatever its goal; sites without one are left out. @pre looks.has_both()
std::map<std::string, std::string> SeatedParts(const PoseHistory& looks,
                                               const SuccessCriterion& success);

/// Parts that have to be taken out before the criterion's literals can all
/// hold: another one is wanted at their site, or they elsewhere.
std::set<std::string> PartsInTheWay(
    const std::map<std::string, std::string>& seated,
    const SuccessCriterion& success);

/// Sites that a literal of the criterion wants a part at.
std::set<std::string> WantedSites(const SuccessCriterion& success);

}  // namespace cell::cli
