#pragma once

#include <string>
#include <vector>

#include "services/cell/evaluations/sec_figures.h"

namespace cell::cli {

/// What the paper's text says about a figure, as a condition on its curves.
struct SecStatement {
  std::string text;       ///< of the paper, in short
  std::string condition;  ///< how it is checked
  std::string found;      ///< the values
  bool is_true = false;
};

/// The statements on `figure`, for the curves of `measure`.
std::vector<SecStatement> CheckStatements(const std::string& figure,
                                          const std::string& measure,
                                          const std::vector<SecCurve>& curves);

}  // namespace cell::cli
