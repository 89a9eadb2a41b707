#pragma once

#include "common/scene/relation.h"
#include "services/cell/pictures/canvas.h"

namespace cell::cli {

/// Of an entry of an event chain.
inline Canvas::Colour ColourOfRelation(Relation relation) {
  switch (relation) {
    case Relation::kNotTouching:
      return {238, 238, 238};
    case Relation::kTouching:
      return {150, 200, 240};
    case Relation::kOverlapping:
      return {245, 190, 110};
    case Relation::kAbsent:
      return {170, 170, 170};
  }
  return {};
}

}  // namespace cell::cli
