#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/sec/chain_clustering.h"
#include "common/sec/event_chain.h"
#include "common/sec/layered_chain.h"
#include "common/sec/relation_matrix.h"
#include "common/task/task.h"
#include "services/cell/evaluations/evaluation.h"
#include "services/cell/evaluations/shown_stream.h"

namespace cell::cli {

/// A placement that was shown, as a learner without labels sees it: the rows of
/// the moved part that change, hands included.
struct ShownChain {
  std::string action;  ///< its label; for scoring alone
  std::string part;    ///< that was moved
  std::string site;    ///< where it was put; for scoring alone
  EventChain chain;
  LayeredChain enriched;  ///< the same with layers, if the stream has them
};

/// Shows the stream to a recognizer that knows nothing.
/// @param names  of placements, by part
/// @param params  without a library
std::vector<ShownChain> ShowChains(
    const ShownStreamParams& params, const Deployment& deployment,
    const Task& task, const std::map<std::string, std::string>& names,
    const std::function<void(const std::string&)>& show);

/// How chains are grouped (section VI-A). Each is ChainClustering with the
/// consensus of a model, and a cut.
struct ShownGrouping {
  std::string name;
  std::string measure;  ///< typed, joint or paper
  ChainClustering::Threshold threshold = ChainClustering::Threshold::kCut;

  bool is_typed() const { return measure == "typed"; }
};
/// The first one is the one whose goals are set for types; those without types
/// come last.
std::vector<ShownGrouping> ShownGroupings();

/// What came of it, in one order of the chains.
struct ShownGroups {
  std::string grouping;
  std::vector<std::map<std::string, int>> models;  ///< actions in each
  int num_all = 0;
  int num_pure = 0;  ///< that have the action of most in their model
  /// Of another action, but of the topology of one of the action of most: by
  /// this measure the two are one.
  int num_same = 0;
  /// That have the topology of a placement of another action, and how many of
  /// them are in a model with one: by this measure they have to be.
  int num_ambiguous = 0;
  int num_ambiguous_merged = 0;

  /// Objects in the roles that the models give them: how many have the role of
  /// most; and the same after the roles of each manipulation were shuffled.
  int num_objects = 0;
  int num_objects_pure = 0;
  int num_objects_pure_shuffled = 0;
};

/// The types of the scene's objects; each hand is a "hand".
ObjectTypes TypesOf(const Task& task);

/// @param seed  of the order in which the chains are shown, and of the shuffled
/// roles
ShownGroups GroupChains(const std::vector<ShownChain>& chains, const Task& task,
                        const ShownGrouping& grouping, uint64_t seed);

/// The models, one a line.
std::string ToText(const ShownGroups& groups);
/// A line per grouping: models, purity.
std::string ShownGroupsTable(const std::vector<ShownGroups>& results);
/// The goals of all orders.
std::vector<Measure> ShownGroupsMeasures(
    const std::vector<ShownGroups>& results);

}  // namespace cell::cli
