#pragma once

#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "cell/execution_t.hpp"
#include "services/vtb/script.h"
#include "services/vtb/world.h"

namespace cell::vtb {

/// What the cell asks a person for, or to be shown: a predicate of objects,
/// where `_` is any.
struct HelpRequest {
  std::string predicate;
  std::vector<std::string> arguments;
  bool is_true = true;  ///< is to become true, or false
};

/// What the cell asks for, unless it is a step that is left to the person.
std::vector<HelpRequest> RequestsOf(const execution_t& message);

/// What a hand can do about it.
struct HelpAction {
  const PlacementRule* rule = nullptr;
  std::string part;
  std::string site;
  /// From the site, or from where it lies, to where it stands on the table.
  bool is_removal = false;
};

/// Places one of the parts `at_hand` where it makes the requested predicate
/// true, or takes out one that makes it true although it should not be, or
/// raises one that lies. The
/// first that is possible as things are; nullopt if none is, or if no placement
/// rule makes the predicate. What the person knows of predicates are the keys
/// `makes` and `lies` of demonstrators.yaml.
std::optional<HelpAction> ActionFor(const HelpRequest& request,
                                    const Demonstrations& demonstrations,
                                    std::span<const std::string> at_hand,
                                    const World& world);

/// The part that sits there by the rule, or nullptr.
const Part* PartAt(const Site& site, const PlacementRule& rule,
                   const World& world);
/// All sites of the type, in the order of the table.
std::vector<const Site*> SitesOf(const PartTable& table,
                                 const std::string& type);
/// All that must come before is in place.
bool IsReady(const PlacementRule& rule, const Demonstrations& demonstrations,
             const World& world);

}  // namespace cell::vtb
