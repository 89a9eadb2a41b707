#pragma once

#include <string>

#include "common/relational/literal.h"
#include "common/sec/scene_facts.h"
#include "common/sec/scene_words.h"
#include "common/sec/sec_library.h"

namespace cell {

/// A scene in which every role of a manipulation stands for an object.
class BoundScene {
 public:
  /// @param moved  the role of the part that is moved
  /// All references must outlive this object.
  BoundScene(const SceneWords& words, const Binding& roles, size_t moved,
             const SensedFrame& sensed)
      : words_(words), roles_(roles), moved_(moved), sensed_(sensed) {}

  /// True if the moved part touches it.
  bool Touches(const Partner& partner) const;
  /// True if the literal may hold, as far as the scene is known.
  bool MayHold(const Literal& literal) const;
  /// True if the scene leaves no doubt that it holds.
  bool MustHold(const Literal& literal) const;

 private:
  bool IsInRole(const std::string& part) const;
  bool TouchesPart(const std::string& part) const;

  const SceneWords& words_;
  const Binding& roles_;
  size_t moved_;
  const SensedFrame& sensed_;
};

}  // namespace cell
