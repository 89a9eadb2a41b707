#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace cell {

/// Spatial relation of an object pair; codes as in the paper's Fig. 12.
enum class Relation : int8_t {
  kNotTouching = 0,
  kTouching = 1,
  kOverlapping = 2,  ///< one contains the other
  kAbsent = 9        ///< one of them is not there
};

/// The relation with this code, or nothing if there is none.
std::optional<Relation> RelationFromCode(int8_t code);

/// Names of two objects, in order.
using ObjectPair = std::pair<std::string, std::string>;
ObjectPair MakePair(const std::string& a, const std::string& b);

/// Relations of all pairs at one instant.
using TouchGraph = std::map<ObjectPair, Relation>;

/// True if the two touch or one contains the other; false for pairs that the
/// graph does not have.
bool Touch(const TouchGraph& graph, const std::string& a, const std::string& b);

}  // namespace cell
