#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/result/result.h"
#include "common/sec/chain_similarity.h"
#include "common/sec/learned_model.h"
#include "common/sec/scene_words.h"
#include "common/sec/sec_library.h"
#include "common/sec/showing.h"

namespace cell {

/// Learns actions from manipulations that are shown one after the other,
/// without labels (sections VI-A, VII-A): showings of the same change with the
/// same types of objects form a group, and what all of a group share is its
/// model. A name groups what types keep apart: groups of one name become one,
/// and its types the narrowest that all have in common.
///
/// The order of the showings decides nothing but the groups' made-up names, and
/// whether an action that nobody has named yet is read forward.
class SecLearner {
 public:
  /// The similarity of event chains by which showings are compared.
  static constexpr char kMeasure[] = "same_row";
  struct Params {
    /// The least similarity of showings of one action.
    double threshold = 0.6;
    /// How much of the similarity the changed predicates decide; the event
    /// chains decide the rest, or all where no predicate has changed.
    double literal_share = 0.7;
  };
  /// What was learned from one manipulation.
  struct Lesson {
    size_t group = 0;  ///< for Name()
    ActionDirection direction = ActionDirection::kForward;
    bool is_new = false;  ///< nothing like it was shown before
  };
  struct Action {
    std::string name;
    bool is_named = false;  ///< by a person
    LearnedModel model;
  };

  SecLearner(std::shared_ptr<const SceneWords> words,
             std::shared_ptr<const ChainSimilarity> similarity,
             const Params& params);

  /// What was learned before; `name` begins with kMadeUp if nobody gave it.
  void Know(const std::string& name, const LearnedModel& model);
  static constexpr char kMadeUp[] = "Action";

  /// Nothing if the manipulation has changed nothing.
  /// @param source  names the demonstration
  std::optional<Lesson> Add(const ObservedManipulation& manipulation,
                            const std::string& source);

  /// A person's name of what was shown; `is_undone`: it undoes the action. What
  /// has the name already becomes one group with it. The name's group.
  /// Refused: a group that has another name, and groups that do not share a
  /// change.
  Result<size_t> Name(const Lesson& lesson, const std::string& name,
                      bool is_undone);

  /// Showings with other objects join the group if their types are these, one
  /// for each role of the group's model: wider than what was shown.
  /// @throws std::invalid_argument for another number of types.
  void Widen(size_t group, const std::vector<int>& types);

  /// By name.
  std::vector<Action> Actions() const;
  /// What was learned of the lesson's action up to now.
  Action ActionOf(const Lesson& lesson) const;

 private:
  struct Group {
    std::string name;
    bool is_named = false;
    std::vector<int> types;  // of the roles; role 0 is moved
    SceneFacts pick, place;  // what all showings share
    EventChain chain;        // of its first showing
    std::map<std::string, int> shown;
  };
  /// How a showing is like a group.
  struct Match {
    double similarity = 0;
    ActionDirection direction = ActionDirection::kForward;
    RoleMap places;  // of the showing's roles in the group
  };

  Match MatchOf(const Group& group, const Showing& showing,
                bool needs_types) const;
  double Similarity(const Group& group, const Showing& showing,
                    const RoleMap& places) const;
  bool AreTypesKnown(const Group& group, const Showing& showing,
                     const RoleMap& places) const;
  void Join(const Showing& showing, const RoleMap& places, Group& group) const;
  LearnedModel ModelOf(const Group& group) const;
  SceneFacts Characteristic(const Group& group, bool at_pick) const;
  /// What the facts of another group say of one of its own.
  enum class Stance { kSilent, kShares, kContradicts };
  bool IsTelling(const Group& group, bool at_pick,
                 const std::function<Stance(const SceneFacts&)>& stance) const;

  std::shared_ptr<const SceneWords> words_;
  std::shared_ptr<const ChainSimilarity> similarity_;
  Params params_;
  std::vector<Group> groups_;  // those that were joined to others are empty
  size_t num_made_up_ = 0;
};

}  // namespace cell
