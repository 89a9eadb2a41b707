#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/scene/relation_layers.h"
#include "common/sec/event_chain.h"

namespace cell {

/// The event chain of a manipulation, enriched with static and dynamic
/// relations (section II-C): each row and column of `touching` has an entry in
/// each layer. A value.
struct LayeredChain {
  std::string part;     ///< that is moved
  EventChain touching;  ///< the rows of the part that change
  /// By rows: of the part to the other object.
  std::vector<std::vector<Place>> places;
  std::vector<std::vector<Motion>> motions;
};

/// Of the part's rows those that change and of the columns those that differ
/// from the one before, in touching: layers enrich the chain and add no rows or
/// columns. A motion is the last one since the column before.
///
/// @param chain  of all pairs
/// @param layers  of its columns
/// @throws std::invalid_argument unless there are as many layers as columns.
LayeredChain EnrichedRowsOf(const std::string& part, const EventChain& chain,
                            std::span<const RelationLayers> layers);

/// A line per row: the code of touching, i inside, h holds, o on, c carries, a
/// above, b below, and > getting closer, < moving apart, = moving together.
///
///   bolt, hand   0   1>  1=  0
///   bolt, table  1o  1o  0a< 1o
std::string ToText(const LayeredChain& chain);

}  // namespace cell
