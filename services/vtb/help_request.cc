#include "services/vtb/help_request.h"

#include <algorithm>

#include "common/predicates/seat.h"

namespace cell::vtb {
namespace {

constexpr char kAny[] = "_";

bool IsAt(const Site& site, const Part& part, const PlacementRule& rule,
          const World& world) {
  const Eigen::Isometry3d X_WS = world.PoseOf(site.host) * site.X_HS;
  return IsSeated(X_WS.inverse() * world.PoseOf(part.name), part.symmetry_order,
                  rule.seated);
}

/// True if every argument is any object, the part or the site.
bool Concerns(const HelpRequest& request, const std::string& part,
              const std::string& site) {
  return std::ranges::all_of(request.arguments, [&](const std::string& name) {
    return name == kAny || name == part || name == site;
  });
}

std::optional<HelpAction> Removal(const HelpRequest& request,
                                  const PlacementRule& rule,
                                  const World& world) {
  for (const Site* site : SitesOf(world.table(), rule.site_type)) {
    const Part* part = PartAt(*site, rule, world);
    if (part != nullptr && Concerns(request, part->name, site->name)) {
      return HelpAction{&rule, part->name, site->name, true};
    }
  }
  return std::nullopt;
}

std::optional<HelpAction> Placing(const HelpRequest& request,
                                  const PlacementRule& rule,
                                  std::span<const std::string> at_hand,
                                  const World& world) {
  for (const Site* site : SitesOf(world.table(), rule.site_type)) {
    if (PartAt(*site, rule, world) != nullptr) continue;
    for (const std::string& part : at_hand) {
      if (world.table().Find(part)->type == rule.part_type &&
          Concerns(request, part, site->name)) {
        return HelpAction{&rule, part, site->name, false};
      }
    }
  }
  return std::nullopt;
}

std::optional<HelpAction> Raising(const HelpRequest& request,
                                  std::span<const std::string> at_hand,
                                  const World& world) {
  constexpr double kLying = 0.7;  // cosine of the tilt
  for (const std::string& part : at_hand) {
    if (world.PoseOf(part).linear()(2, 2) < kLying &&
        Concerns(request, part, "")) {
      return HelpAction{nullptr, part, "", true};
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<HelpRequest> RequestsOf(const execution_t& message) {
  std::vector<HelpRequest> requests;
  if (message.state != execution_t::STUCK || !message.help_part.empty()) {
    return requests;
  }
  for (const literal_t& literal : message.needed) {
    requests.push_back({literal.predicate, literal.arguments,
                        literal.value == literal_t::TRUE_});
  }
  return requests;
}

std::optional<HelpAction> ActionFor(const HelpRequest& request,
                                    const Demonstrations& demonstrations,
                                    std::span<const std::string> at_hand,
                                    const World& world) {
  if (!request.is_true && !request.predicate.empty() &&
      request.predicate == demonstrations.lies) {
    return Raising(request, at_hand, world);
  }
  for (const auto& [name, rule] : demonstrations.rules) {
    if (rule.makes.empty() || rule.makes != request.predicate) continue;
    if (request.is_true && !IsReady(rule, demonstrations, world)) continue;
    const auto action = request.is_true ? Placing(request, rule, at_hand, world)
                                        : Removal(request, rule, world);
    if (action) return action;
  }
  return std::nullopt;
}

const Part* PartAt(const Site& site, const PlacementRule& rule,
                   const World& world) {
  for (const Part& part : world.table().parts()) {
    if (part.type == rule.part_type && IsAt(site, part, rule, world)) {
      return &part;
    }
  }
  return nullptr;
}

std::vector<const Site*> SitesOf(const PartTable& table,
                                 const std::string& type) {
  std::vector<const Site*> sites;
  for (const Part& host : table.parts()) {
    for (const Site& site : host.sites) {
      if (site.type == type) sites.push_back(&site);
    }
  }
  return sites;
}

bool IsReady(const PlacementRule& rule, const Demonstrations& demonstrations,
             const World& world) {
  return std::ranges::all_of(rule.after, [&](const std::string& before) {
    const PlacementRule& earlier = demonstrations.rules.at(before);
    return std::ranges::all_of(
        SitesOf(world.table(), earlier.site_type), [&](const Site* site) {
          return PartAt(*site, earlier, world) != nullptr;
        });
  });
}

}  // namespace cell::vtb
