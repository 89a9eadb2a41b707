#pragma once

#include "common/parts/part_table.h"
#include "common/relational/vocabulary.h"

namespace cell {

/// What the facts of a scene are said in: the words of a domain, and its parts.
struct SceneWords {
  Vocabulary vocabulary;
  PartTable parts;
};

}  // namespace cell
