#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

/// What ExcuseRow() says of the states of one kind of damage, or of all.
struct ExcuseFigures {
  std::string damage;
  int num_states = 0;
  int num_minimal = 0;
  int num_holding = 0;  ///< a predicate that is missing, in one excuse
  int num_first = 0;    ///< the same, in the best one
  int num_named = 0;
  int num_helping = 0;
  int num_good = 0;  ///< minimal, holding, named and helping
  int largest = 0;   ///< excuse, in changes
  int num_with_plan = 0;
  int num_other = 0;
};

/// Of what ExcuseRow() makes.
RowShape ExcuseRowShape();

/// One for each kind of damage that is there, in the order of their names, then
/// one for all.
std::vector<ExcuseFigures> SummariseExcuses(
    const std::vector<nlohmann::json>& rows);

/// For people, with the 95 % interval of the states where all is well.
std::string ExcuseText(const std::vector<ExcuseFigures>& figures);
std::string ExcuseCsv(const std::vector<ExcuseFigures>& figures);

}  // namespace cell::cli
