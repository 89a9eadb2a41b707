#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/parts/part_table.h"
#include "common/relational/vocabulary.h"
#include "common/sec/sec_conditions.h"
#include "common/sec/sec_library.h"

namespace cell {

/// The SEC models that were written by hand: conditions on the scene before
/// the pick-up and after the placement. An action read backwards begins with
/// its placement.
class ConditionLibrary final : public SecLibrary {
 public:
  struct Entry {
    std::string action;
    std::vector<Variable> arguments;
    SecConditions conditions;
  };

  ConditionLibrary(std::vector<Entry> entries, const Vocabulary& vocabulary,
                   const PartTable& parts);

  const Models& models() const override { return models_; }
  double threshold() const override { return 1; }

 private:
  Models models_;
};

}  // namespace cell
