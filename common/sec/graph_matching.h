#pragma once

#include <map>
#include <optional>
#include <string>

#include "common/scene/relation.h"
#include "common/sec/relation_matrix.h"

namespace cell {

/// Which object of one graph each object of another is.
using ObjectMap = std::map<std::string, std::string>;

/// Matches the main graphs of two key frames exactly (section V-B): one-to-one,
/// so that objects of one kind correspond and each pair has the relation of the
/// pair that it corresponds to. Returns nullopt if there is no such match, or
/// else the first in the order of names, in which as many objects as possible
/// at the front stay themselves.
///
/// `kinds` names what cannot be told apart; an object that it does not list is
/// a kind of its own. Pairs that a graph does not list do not touch.
///
/// By search with backtracking over objects of one kind. Only such objects as
/// have equally many relations of each sort with each kind are tried, so that
/// the scenes of a cell take little more than one look at each pair; the worst
/// case grows with the factorial of the number of objects of a kind.
std::optional<ObjectMap> MatchGraphs(const TouchGraph& a, const TouchGraph& b,
                                     const ObjectTypes& kinds);

}  // namespace cell
