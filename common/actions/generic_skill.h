#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/predicates/predicate_geometry.h"
#include "common/relational/skill.h"
#include "common/relational/vocabulary.h"
#include "common/sec/learned_model.h"

namespace cell {

/// How arms do an action that was only shown, until they are taught: they
/// insert the moved part at the site where it was seated, with the arm that
/// feels forces.
class GenericSkill {
 public:
  /// @param geometries  of each predicate of the vocabulary
  GenericSkill(const Vocabulary& vocabulary,
               std::span<const PredicateGeometry> geometries,
               const CellLayout& layout);

  /// The skill, said of the model's roles; nullopt if no predicate tells that
  /// the part was seated at a site, or no arm feels forces.
  std::optional<SkillBinding> For(const LearnedModel& model) const;

 private:
  /// Where a predicate says that its first argument is seated.
  struct Seat {
    bool is_second_argument = false;
    int site = 0;  ///< of the vocabulary, otherwise
  };

  std::vector<std::optional<Seat>> seats_;  // of each predicate
  std::optional<int> arm_;                  // of the vocabulary
};

}  // namespace cell
