#pragma once

#include <vector>

namespace cell::planning {

/// Of each node its choices, of each choice the nodes that it may lead to.
using LocalGraph = std::vector<std::vector<std::vector<int>>>;

/// The maximal end components: sets of nodes, each with some of its choices,
/// within which every node can be reached from every other and no choice leads
/// out (de Alfaro, 1997). Nodes ascend within each, first nodes between them; a
/// node by itself counts if one of its choices stays there.
std::vector<std::vector<int>> EndComponents(const LocalGraph& graph);

}  // namespace cell::planning
