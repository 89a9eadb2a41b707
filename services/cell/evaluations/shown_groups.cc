#include "services/cell/evaluations/shown_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <span>
#include <utility>

#include "common/sec/chain_alignment.h"
#include "common/sec/chain_noise.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/learned_library.h"
#include "common/sec/paper_similarity.h"
#include "common/sec/typed_similarity.h"

namespace cell::cli {
namespace {

/// Before there is a distribution, only what is nearly equal is one.
constexpr double kFirstOfHighest = 0.9;
constexpr double kSame = 0.999;          // similarity of chains of one topology
constexpr int64_t kLabelUs = 1'500'000;  // between the action and its key frame

struct Seen {
  std::string part;
  int64_t utime = 0;
  EventChain chain;         // of all pairs
  size_t first_column = 0;  // index of its first key frame
};

/// The placement that this is, if the person has done one.
const Recording::TrueAction* PlacementOf(
    const Seen& seen, const std::vector<ShownStream::Done>& done) {
  for (const ShownStream::Done& d : done) {
    if (d.action.kind == Recording::TrueAction::Kind::kPlaced &&
        d.action.part == seen.part &&
        std::llabs(d.action.utime - seen.utime) <= kLabelUs) {
      return &d.action;
    }
  }
  return nullptr;
}

ChainClustering::Params ParamsOf(const ShownGrouping& grouping) {
  ChainClustering::Params params;
  if (grouping.is_typed()) {
    params.similarity = std::make_shared<TypedSimilarity>();
  } else if (grouping.measure == "joint") {
    params.similarity = std::make_shared<JointSimilarity>();
  } else {
    params.similarity = std::make_shared<PaperSimilarity>();
  }
  params.model.roles =
      grouping.is_typed() ? RowRoles::kKept : RowRoles::kIgnored;
  params.threshold = grouping.threshold;
  if (grouping.threshold == ChainClustering::Threshold::kHighestCut) {
    params.first_threshold = kFirstOfHighest;
  }
  return params;
}

/// What the other object of a row is to the manipulation.
std::string TrueRole(const std::string& object, const ShownChain& shown,
                     const Task& task) {
  if (object == SceneObjects::kTable) return "table";
  if (!task.scene_objects.IsPart(object)) return "hand";
  const Site* site = task.parts.FindSite(shown.site);
  return site != nullptr && site->host == object ? "host" : "neighbour";
}

/// Objects by the role that a group gives them.
class RoleCount {
 public:
  void Add(size_t group, size_t row, const std::string& role) {
    ++counts_[{group, row}][role];
  }
  int NumPure() const {
    int num = 0;
    for (const auto& [place, roles] : counts_) {
      int most = 0;
      for (const auto& [role, count] : roles) most = std::max(most, count);
      num += most;
    }
    return num;
  }

 private:
  std::map<std::pair<size_t, size_t>, std::map<std::string, int>> counts_;
};

void CountRoles(const std::vector<ShownChain>& chains, const Task& task,
                const std::vector<RelationMatrix>& matrices,
                const ChainClustering& clustering, RowRoles kept,
                std::mt19937_64& random, ShownGroups* result) {
  RoleCount counted, shuffled;
  const auto& clusters = clustering.clusters();
  for (size_t g = 0; g < clusters.size(); ++g) {
    const RelationMatrix model = clusters[g].model.Consensus();
    for (const size_t i : clusters[g].samples) {
      // Row 0 of a group is the moved part's, row r + 1 that of row r.
      std::vector<std::pair<size_t, std::string>> roles = {{0, "moved"}};
      const auto alignment = AlignChains(model, matrices[i], kept);
      for (const auto& [of_model, of_sample] : alignment.rows) {
        const auto& [first, second] = chains[i].chain.pairs()[of_sample];
        roles.push_back(
            {of_model + 1, TrueRole(first == chains[i].part ? second : first,
                                    chains[i], task)});
      }
      for (const auto& [row, role] : roles) counted.Add(g, row, role);
      for (size_t j = roles.size(); j > 1; --j) {
        std::swap(roles[j - 1].second, roles[DrawBelow(j, random)].second);
      }
      for (const auto& [row, role] : roles) shuffled.Add(g, row, role);
      result->num_objects += static_cast<int>(roles.size());
    }
  }
  result->num_objects_pure = counted.NumPure();
  result->num_objects_pure_shuffled = shuffled.NumPure();
}

/// Which chains have the same topology by a measure, and which action each has.
class SameTopology {
 public:
  SameTopology(const std::vector<ShownChain>& chains,
               const std::vector<RelationMatrix>& matrices,
               const MatrixSimilarity& similarity)
      : chains_(chains), same_topology_(chains.size()) {
    for (size_t i = 0; i < chains.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        if (chains[i].action == chains[j].action ||
            similarity.Between(matrices[i], matrices[j]) < kSame) {
          continue;
        }
        same_topology_[i].push_back(j);
        same_topology_[j].push_back(i);
      }
    }
  }

  /// @param samples  of one model, rising, most of which are of this action
  void Count(const std::vector<size_t>& samples, const std::string& main,
             ShownGroups* result) const {
    for (const size_t i : samples) {
      const auto in_model = [&](size_t j) {
        return std::ranges::binary_search(samples, j);
      };
      result->num_ambiguous += !same_topology_[i].empty();
      result->num_ambiguous_merged +=
          std::ranges::any_of(same_topology_[i], in_model);
      result->num_same += chains_[i].action != main &&
                          std::ranges::any_of(same_topology_[i], [&](size_t j) {
                            return chains_[j].action == main && in_model(j);
                          });
    }
  }

 private:
  const std::vector<ShownChain>& chains_;
  std::vector<std::vector<size_t>> same_topology_;  // of other actions
};

/// The goals of measures without types are those of the highest cut.
bool IsUntypedGoal(const std::string& name) {
  const auto groupings = ShownGroupings();
  const auto it = std::ranges::find(groupings, name, &ShownGrouping::name);
  return it != groupings.end() && !it->is_typed() &&
         it->threshold == ChainClustering::Threshold::kHighestCut;
}

void Shuffle(std::vector<ShownChain>* chains, std::mt19937_64& random) {
  for (size_t i = chains->size(); i > 1; --i) {
    std::swap((*chains)[i - 1], (*chains)[DrawBelow(i, random)]);
  }
}

}  // namespace

std::vector<ShownChain> ShowChains(
    const ShownStreamParams& params, const Deployment& deployment,
    const Task& task, const std::map<std::string, std::string>& names,
    const std::function<void(const std::string&)>& show) {
  ShownStreamParams unknowing = params;
  unknowing.library = std::make_shared<const LearnedLibrary>(
      std::vector<LearnedLibrary::Entry>{},
      std::make_shared<const SceneWords>(
          SceneWords{task.domain.vocabulary(), task.parts}));
  std::vector<Seen> all;
  const ShownStream stream = ShowStream(
      unknowing, deployment, task, show,
      [&](const ObservedManipulation& manipulation, const auto&) {
        all.push_back({manipulation.part, manipulation.after.frame.utime,
                       manipulation.chain,
                       static_cast<size_t>(manipulation.before.frame.index)});
      });
  std::vector<ShownChain> chains;
  for (const Seen& seen : all) {
    const auto* placement = PlacementOf(seen, stream.done);
    EventChain chain =
        seen.chain.RowsOf(seen.part).ChangingRows().DistinctColumns();
    if (placement == nullptr || chain.num_rows() == 0) continue;
    ShownChain& shown = chains.emplace_back(ShownChain{
        names.at(seen.part), seen.part, placement->site, std::move(chain), {}});
    if (!params.has_layers) continue;
    shown.enriched = EnrichedRowsOf(
        seen.part, seen.chain,
        std::span(stream.layers)
            .subspan(seen.first_column, seen.chain.num_columns()));
  }
  return chains;
}

ObjectTypes TypesOf(const Task& task) {
  ObjectTypes types;
  for (const Part& part : task.parts.parts()) types[part.name] = part.type;
  for (const std::string& hand : task.scene_objects.hands()) {
    types[hand] = "hand";
  }
  return types;
}

std::vector<ShownGrouping> ShownGroupings() {
  using enum ChainClustering::Threshold;
  return {{"typed", "typed", kCut},
          {"typed, highest cut", "typed", kHighestCut},
          {"joint, cut", "joint", kCut},
          {"joint, highest cut", "joint", kHighestCut},
          {"paper, highest cut", "paper", kHighestCut}};
}

ShownGroups GroupChains(const std::vector<ShownChain>& all, const Task& task,
                        const ShownGrouping& grouping, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<ShownChain> chains = all;
  Shuffle(&chains, random);
  RoleTable table(TypesOf(task));
  std::vector<RelationMatrix> matrices;
  const ChainClustering::Params params = ParamsOf(grouping);
  ChainClustering clustering(params);
  for (const ShownChain& shown : chains) {
    matrices.emplace_back(shown.chain, &table);
    clustering.Add(matrices.back());
  }
  ShownGroups result{.grouping = grouping.name,
                     .models = {},
                     .num_all = static_cast<int>(chains.size())};
  const SameTopology same_topology(chains, matrices, *params.similarity);
  for (const auto& cluster : clustering.clusters()) {
    std::map<std::string, int> actions;
    for (const size_t i : cluster.samples) ++actions[chains[i].action];
    const auto main = std::ranges::max_element(
        actions, {}, [](const auto& entry) { return entry.second; });
    result.num_pure += main->second;
    same_topology.Count(cluster.samples, main->first, &result);
    result.models.push_back(std::move(actions));
  }
  CountRoles(chains, task, matrices, clustering, params.model.roles, random,
             &result);
  return result;
}

std::string ToText(const ShownGroups& groups) {
  std::string text = fmt::format("{}, one order:\n", groups.grouping);
  for (const auto& model : groups.models) {
    text += " ";
    for (const auto& [action, count] : model) {
      text += fmt::format(" {} {}", count, action);
    }
    text += "\n";
  }
  return text;
}

std::string ShownGroupsTable(const std::vector<ShownGroups>& results) {
  std::string text = fmt::format(
      "{:20} {:>16} {:>8} {:>22} {:>14} {:>10}\n", "grouping", "models",
      "purity", "and the same topology", "roles, purity", "shuffled");
  for (const ShownGrouping& grouping : ShownGroupings()) {
    size_t sum = 0, least = SIZE_MAX, most = 0;
    int orders = 0;
    ShownGroups all;
    for (const ShownGroups& result : results) {
      if (result.grouping != grouping.name) continue;
      ++orders;
      sum += result.models.size();
      least = std::min(least, result.models.size());
      most = std::max(most, result.models.size());
      all.num_all += result.num_all;
      all.num_pure += result.num_pure;
      all.num_same += result.num_same;
      all.num_objects += result.num_objects;
      all.num_objects_pure += result.num_objects_pure;
      all.num_objects_pure_shuffled += result.num_objects_pure_shuffled;
    }
    if (orders == 0 || all.num_all == 0) continue;
    text += fmt::format(
        "{:20} {:4.1f} ({:2} to {:2})  {:6.1f} % {:20.1f} % {:12.1f} % {:8.1f} "
        "%\n",
        grouping.name, static_cast<double>(sum) / orders, least, most,
        100.0 * all.num_pure / all.num_all,
        100.0 * (all.num_pure + all.num_same) / all.num_all,
        100.0 * all.num_objects_pure / all.num_objects,
        100.0 * all.num_objects_pure_shuffled / all.num_objects);
  }
  return text;
}

std::vector<Measure> ShownGroupsMeasures(
    const std::vector<ShownGroups>& results) {
  Measure models{"orders with six or seven models", 0, 0, std::nullopt, 1};
  Measure purity{"placements in a model of their action", 0, 0, std::nullopt,
                 0.98};
  Measure roles{"objects in a role of their kind", 0, 0, std::nullopt, 0.95};
  Measure topology{"no types: in a model of their topology", 0, 0, std::nullopt,
                   0.98};
  Measure ambiguous{"no types: same topology, so merged", 0, 0, std::nullopt,
                    0.98};
  const auto groupings = ShownGroupings();
  for (const ShownGroups& result : results) {
    if (result.grouping == groupings.front().name) {
      ++models.num_all;
      models.num_good += result.models.size() == 6 || result.models.size() == 7;
      purity.num_all += result.num_all;
      purity.num_good += result.num_pure;
      roles.num_all += result.num_objects;
      roles.num_good += result.num_objects_pure;
    }
    if (!IsUntypedGoal(result.grouping)) continue;
    topology.num_all += result.num_all;
    topology.num_good += result.num_pure + result.num_same;
    ambiguous.num_all += result.num_ambiguous;
    ambiguous.num_good += result.num_ambiguous_merged;
  }
  return {models, purity, roles, topology, ambiguous};
}

}  // namespace cell::cli
