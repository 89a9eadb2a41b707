#include "services/cell/evaluations/excuse_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "services/cell/scoring/interval.h"

namespace cell::cli {

using nlohmann::json;
namespace {

void Add(const json& row, ExcuseFigures* figures) {
  const bool is_minimal = row.at("minimal");
  const bool is_holding = row.at("holds");
  const bool is_named = row.at("named");
  const bool is_helping = row.at("helps");
  ++figures->num_states;
  figures->num_minimal += is_minimal;
  figures->num_holding += is_holding;
  figures->num_first += row.at("first").get<bool>();
  figures->num_named += is_named;
  figures->num_helping += is_helping;
  figures->num_good += is_minimal && is_holding && is_named && is_helping;
  figures->largest = std::max(figures->largest, row.at("size").get<int>());
  figures->num_with_plan += row.at("with_plan").get<int>();
  figures->num_other += row.at("other").get<int>();
}

}  // namespace

RowShape ExcuseRowShape() {
  using enum RowShape::Kind;
  return RowShape::Counts({"size", "with_plan", "other"})
      .With({{"seed", kSeed},
             {"damage", kText},
             {"what", kText},
             {"excuses", kText},
             {"text", kText},
             {"minimal", kFlag},
             {"holds", kFlag},
             {"first", kFlag},
             {"named", kFlag},
             {"helps", kFlag}});
}

std::vector<ExcuseFigures> SummariseExcuses(const std::vector<json>& rows) {
  std::map<std::string, ExcuseFigures> by_damage;
  ExcuseFigures all{"all"};
  for (const json& row : rows) {
    const std::string damage = row.at("damage");
    by_damage[damage].damage = damage;
    Add(row, &by_damage[damage]);
    Add(row, &all);
  }
  std::vector<ExcuseFigures> figures;
  for (const auto& [damage, entry] : by_damage) figures.push_back(entry);
  figures.push_back(all);
  return figures;
}

std::string ExcuseText(const std::vector<ExcuseFigures>& figures) {
  std::string text = fmt::format(
      "{:20} {:>6} {:>8} {:>14} {:>6} {:>6} {:>8} {:>14} {:>8} {:>9}\n",
      "damage", "states", "minimal", "holds missing", "named", "helps",
      "all four", "95 % interval", "largest", "in first");
  for (const ExcuseFigures& f : figures) {
    const Interval interval = WilsonInterval(f.num_good, f.num_states);
    text += fmt::format(
        "{:20} {:>6} {:>8} {:>14} {:>6} {:>6} {:>8} {:>14} {:>8} {:>9}\n",
        f.damage, f.num_states, f.num_minimal, f.num_holding, f.num_named,
        f.num_helping, f.num_good,
        fmt::format("{:.1f} - {:.1f} %", 100 * interval.low,
                    100 * interval.high),
        f.largest, f.num_first);
  }
  const ExcuseFigures& all = figures.back();
  return text + fmt::format(
                    "{} draws had a plan all the same; in {} no smallest "
                    "change holds what is missing\n",
                    all.num_with_plan, all.num_other);
}

std::string ExcuseCsv(const std::vector<ExcuseFigures>& figures) {
  std::string text =
      "damage,states,minimal,holds_missing,named,helps,all_four,low,high,"
      "largest,missing_in_first,draws_with_plan,draws_of_other_changes\n";
  for (const ExcuseFigures& f : figures) {
    const Interval interval = WilsonInterval(f.num_good, f.num_states);
    text += fmt::format("{},{},{},{},{},{},{},{:.4f},{:.4f},{},{},{},{}\n",
                        f.damage, f.num_states, f.num_minimal, f.num_holding,
                        f.num_named, f.num_helping, f.num_good, interval.low,
                        interval.high, f.largest, f.num_first, f.num_with_plan,
                        f.num_other);
  }
  return text;
}

}  // namespace cell::cli
