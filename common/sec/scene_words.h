#pragma once

#include <string>

#include "common/parts/part_table.h"
#include "common/relational/vocabulary.h"

namespace cell {

/// What the facts of a scene are said in: the words of a domain, and its parts.
struct SceneWords {
  Vocabulary vocabulary;
  PartTable parts;

  /// The name of the part that an object is; for a site, of the part that has
  /// the site.
  const std::string& PartOf(int object) const;
};

}  // namespace cell
