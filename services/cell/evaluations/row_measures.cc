#include "services/cell/evaluations/row_measures.h"

namespace cell::cli {

using nlohmann::json;

Measure ShareOf(const std::vector<json>& rows, const std::string& group,
                const std::string& what, const std::string& good,
                const std::string& all) {
  Measure measure{.name = group + ": " + what};
  for (const json& row : rows) {
    if (row.at("group") != group) continue;
    measure.num_good += row.at(good).get<int>();
    measure.num_all += row.at(all).get<int>();
  }
  return measure;
}

Measure RunsOf(const std::vector<json>& rows, const std::string& group,
               const std::string& what,
               const std::function<bool(const json&)>& is_good) {
  Measure measure{.name = group + ": " + what};
  for (const json& row : rows) {
    if (row.at("group") != group) continue;
    measure.num_good += is_good(row);
    ++measure.num_all;
  }
  return measure;
}

}  // namespace cell::cli
