#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/sec/chain_similarity.h"
#include "common/sec/learned_model.h"
#include "common/sec/scene_words.h"

namespace cell {

/// What can stand in for what: actions by what they change and how their event
/// chains run, types of objects by the roles that they play in them.
///
///   similarity(a, b) = max over roles R of 0.7 overlap(a, R b) + 0.3 chains
///
/// `overlap` is the Jaccard index of the literals of the moved part that
/// change, R gives the roles of one action to those of the other (moved part to
/// moved part), whatever their types; without such literals in both, the chains
/// decide alone. Two types are as alike as the most similar actions in which
/// they play corresponding roles. From 0 to 1, symmetric, 1 with itself.
class RoleSimilarity {
 public:
  using Models = std::map<std::string, LearnedModel>;

  /// All references must outlive this object.
  RoleSimilarity(const Models& models, const SceneWords& words,
                 const ChainSimilarity& chains);

  /// Of the actions in their order, row by row.
  std::vector<std::vector<double>> OfActions() const;
  /// The types of objects that have played a role, by name. A demonstration
  /// that showed several is known by the narrowest that they have in common:
  /// all objects of it count.
  std::vector<std::string> Types() const;
  /// Of Types(), row by row.
  std::vector<std::vector<double>> OfTypes() const;

  /// An object whose type was never shown as the moved part, but that can
  /// stand in for it: something of the other roles fits it.
  struct StandIn {
    std::string object;
    std::string action;
    bool operator==(const StandIn&) const = default;
  };
  std::vector<StandIn> AllStandIns() const;

 private:
  struct Player {
    size_t model;
    size_t role;  // 0: the moved part
    bool operator==(const Player&) const = default;
  };

  /// @param roles  that must correspond; nothing: any
  double Between(size_t a, size_t b,
                 const std::pair<size_t, size_t>* roles) const;

  const SceneWords& words_;
  const ChainSimilarity& chains_;
  std::vector<std::string> names_;
  std::vector<LearnedModel> models_;                    // role 0 is moved
  std::map<std::string, std::vector<Player>> players_;  // by type
};

/// Groups of what is similar, directly or by way of others: connected
/// components of the pairs from `threshold` on, in order of their first member.
std::vector<std::vector<size_t>> GroupsOf(
    const std::vector<std::vector<double>>& similarities, double threshold);

}  // namespace cell
