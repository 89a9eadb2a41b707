#include "services/cell/evaluations/size_control.h"

#include <algorithm>

namespace cell::cli {
namespace {

double Ratio(size_t a, size_t b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<double>(low) / static_cast<double>(high);
}

}  // namespace

double SizeControl::OfSorted(const RelationMatrix& a,
                             const RelationMatrix& b) const {
  return Ratio(a.num_rows(), b.num_rows()) *
         Ratio(a.num_columns(), b.num_columns());
}

}  // namespace cell::cli
