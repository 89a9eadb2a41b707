#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/layout/arm_layout.h"
#include "common/predicates/predicate_geometry.h"
#include "common/relational/skill.h"
#include "common/relational/vocabulary.h"
#include "common/sec/learned_model.h"

namespace cell::recognizer {

/// What lets arms try an action that was only shown, until its own motion has
/// been taught: "insert part at site". The part is the one that was moved, the
/// site the one at which it is seated afterwards and was not before.
class GenericSkill {
 public:
  /// @param geometries  of the predicates of the vocabulary, in their order
  /// @param arm  object of the vocabulary that inserts
  GenericSkill(const Vocabulary& vocabulary,
               std::span<const PredicateGeometry> geometries, int arm);

  /// Nothing if the showings do not end with the part at a site.
  std::optional<SkillBinding> For(const LearnedModel& model) const;

  /// The arm of the task that inserts: inserting needs a force-torque sensor;
  /// of several arms with one, that which others make way for. Nothing if none
  /// has one, or the vocabulary does not know it.
  static std::optional<int> ArmThatInserts(std::span<const ArmLayout> arms,
                                           const Vocabulary& vocabulary);

 private:
  std::optional<Term> SiteOf(const Literal& literal, size_t moved) const;

  /// A predicate of being at a site.
  struct Seated {
    std::optional<int> site;  ///< object; nothing: its second argument
  };
  std::vector<std::optional<Seated>> seated_;  // by predicate
  Term arm_;
};

}  // namespace cell::recognizer
