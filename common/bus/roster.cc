#include "common/bus/roster.h"

#include <set>
#include <stdexcept>
#include <utility>

#include "common/text/nearest.h"

namespace cell {

Roster Roster::FromConfig(const Config& config, const std::string& option) {
  Roster roster;
  bool has_option = option.empty();
  roster.task = config.Get<std::string>("task");
  std::set<std::string> names;
  for (const Config& item : config["services"].Items()) {
    Entry entry{item.Get<std::string>("name"), item.Integer("latency", 1, 1000),
                item.GetOr<std::string>("truth_role", ""),
                item.GetOr<bool>("feeds_clock", false)};
    if (!names.insert(entry.name).second) {
      item.Fail("'" + entry.name + "' is listed twice");
    }
    if (item.Has("option")) {
      const bool is_asked = item.Get<std::string>("option") == option;
      has_option |= is_asked;
      if (!is_asked) {
        roster.absent.push_back(std::move(entry.name));
        continue;
      }
    }
    if (roster.entries.empty() && entry.latency != 1) {
      item.Fail("the clock comes first and answers within its tick: latency 1");
    }
    roster.entries.push_back(std::move(entry));
  }
  if (roster.entries.empty()) config["services"].Fail("names no service");
  if (!has_option) {
    config["services"].Fail("has no service with the option " + option);
  }
  config.Finish();
  return roster;
}

std::optional<size_t> Roster::IndexOf(const std::string& name) const {
  for (size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].name == name) return i;
  }
  return std::nullopt;
}

size_t Roster::RequireIndexOf(const std::string& name) const {
  const auto index = IndexOf(name);
  if (!index) {
    throw std::invalid_argument(
        "'" + name + "' is not in the roster" +
        NamesInstead(name, NamesIn(entries, &Entry::name)));
  }
  return *index;
}

}  // namespace cell
