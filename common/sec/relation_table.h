#pragma once

#include <string>
#include <string_view>

#include "common/sec/event_chain.h"

namespace cell {

/// The event chain of a table of relations over time (CSV), a line per frame:
///
///   frame,hand_cup,cup_table
///   0,0,1
///   1,0.73,1
///
/// The first column counts frames; they increase. Every other column is a row
/// of the chain: its name is the pair, split at '/' or else at the first '_'.
/// A number from 0 to 1 says how sure the two touch: from `threshold` on they
/// do. 2 stands for overlapping, 9 for absent. Only rows that change and frames
/// in which something changes are kept.
///
/// @throws std::invalid_argument that begins with "`source`:line: " if the
/// table has no column of a pair, no frame, or no row that changes; a pair
/// twice; a line of another number of values; a value that is none of these; a
/// frame that is no whole number, repeats, or is out of order.
EventChain ChainFromTable(std::string_view table, double threshold,
                          const std::string& source);

}  // namespace cell
