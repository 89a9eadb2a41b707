#include "services/cell/scoring/true_progress.h"

#include <algorithm>

namespace cell::cli {

TrueProgress::TrueProgress(const vtb::Demonstrations& demonstrations,
                           const PartTable& parts) {
  for (const Part& part : parts.parts()) {
    if (part.is_free()) parts_of_[part.type].push_back(part.name);
  }
  for (const auto& [name, rule] : demonstrations.rules) {
    size_t num_left = parts_of_[rule.part_type].size();
    for (const Part& host : parts.parts()) {
      for (const Site& site : host.sites) {
        if (site.type != rule.site_type || num_left == 0) continue;
        placements_.push_back({&rule, site.name});
        --num_left;
      }
    }
  }
}

void TrueProgress::Update(const truth_action_t& action) {
  outside_.erase(action.part);
  jammed_.erase(action.part);
  if (action.mistake == truth_action_t::OUT_OF_WORKSPACE) {
    outside_.insert(action.part);
  } else if (action.mistake == truth_action_t::NOT_SEATED) {
    jammed_.insert(action.part);
  }
  if (action.kind == truth_action_t::TIPPED &&
      !lying_.insert(action.part).second) {
    lying_.erase(action.part);
  }
  Placement* placement = FindSite(action.site);
  if (placement == nullptr) return;
  if (action.kind == truth_action_t::PLACED) {
    placement->part = action.part;
    lying_.erase(action.part);
  } else if (action.kind == truth_action_t::TAKEN_BACK) {
    placement->part.clear();
  }
}

std::optional<int> TrueProgress::NumLeft() const {
  if (!jammed_.empty()) return std::nullopt;
  const std::vector<bool> not_in_place = NotInPlace();
  int num_left = 0;
  std::map<std::string, int> num_open;  // by type of the part
  for (size_t i = 0; i < placements_.size(); ++i) {
    if (!not_in_place[i]) continue;
    const Placement& placement = placements_[i];
    num_left += placement.part.empty() ? 1 : 2;
    if (placement.part.empty()) ++num_open[placement.rule->part_type];
  }
  for (const auto& [type, num] : num_open) {
    int num_usable = 0, num_upright = 0;
    for (const std::string& part : parts_of_.at(type)) {
      if (IsPlaced(part) || outside_.contains(part)) continue;
      ++num_usable;
      num_upright += !lying_.contains(part);
    }
    if (num_usable < num) return std::nullopt;
    num_left += std::max(0, num - num_upright);
  }
  return num_left;
}

TrueProgress::Placement* TrueProgress::FindSite(const std::string& site) {
  const auto it = std::ranges::find(placements_, site, &Placement::site);
  return it == placements_.end() ? nullptr : &*it;
}

bool TrueProgress::IsPlaced(const std::string& part) const {
  return std::ranges::find(placements_, part, &Placement::part) !=
         placements_.end();
}

std::vector<bool> TrueProgress::NotInPlace() const {
  std::vector<bool> result;
  for (const Placement& placement : placements_) {
    result.push_back(placement.part.empty());
  }
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (size_t i = 0; i < placements_.size(); ++i) {
      if (result[i]) continue;
      for (size_t j = 0; j < placements_.size(); ++j) {
        if (!result[j] || std::ranges::count(placements_[i].rule->after,
                                             placements_[j].rule->name) == 0) {
          continue;
        }
        result[i] = has_changed = true;
        break;
      }
    }
  }
  return result;
}

std::map<std::string, int> EmptySitesWithout(
    const std::set<std::string>& missing_parts,
    const vtb::Demonstrations& demonstrations, const PartTable& parts) {
  std::map<std::string, int> num_sites, empty;  // by type of site
  for (const Part& host : parts.parts()) {
    for (const Site& site : host.sites) ++num_sites[site.type];
  }
  for (const auto& [name, rule] : demonstrations.rules) {
    const auto num_parts =
        std::ranges::count_if(parts.parts(), [&](const Part& part) {
          return part.type == rule.part_type && part.is_free() &&
                 !missing_parts.contains(part.name);
        });
    const int num = num_sites[rule.site_type] - static_cast<int>(num_parts);
    if (num > 0) empty[rule.site_type] = num;
  }
  for (size_t before = empty.size() + 1; before != empty.size();) {
    before = empty.size();
    for (const auto& [name, rule] : demonstrations.rules) {
      const bool must_wait =
          std::ranges::any_of(rule.after, [&](const std::string& earlier) {
            return empty.contains(demonstrations.rules.at(earlier).site_type);
          });
      if (must_wait) empty[rule.site_type] = num_sites[rule.site_type];
    }
  }
  return empty;
}

}  // namespace cell::cli
