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
#include "common/sec/showing_group.h"

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
    /// In the roles of the group's model; -1: the showing has none there.
    Binding objects = {};
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
  static bool IsMadeUp(const std::string& name);

  /// Nothing if the manipulation has changed nothing.
  /// @param source  names the demonstration
  /// @param build  that learns it
  std::optional<Lesson> Add(const ObservedManipulation& manipulation,
                            const std::string& source,
                            const std::string& build = "");

  /// Reads all of the lesson's group backwards from now on: what was shown
  /// undoes the action. @pre the lesson is of a group that nobody has named.
  void TurnAround(Lesson* lesson);

  /// A person's name of what was shown; `is_undone`: it undoes the action. What
  /// has the name already becomes one group with it. The name's group.
  /// Refused: a group that has another name, and groups that do not share a
  /// change.
  Result<size_t> Name(const Lesson& lesson, const std::string& name,
                      bool is_undone);

  /// What has been learned of an action becomes part of another, and is gone.
  /// Refused: one that is not known, and those that do not share a change.
  Result<bool> Merge(const std::string& name, const std::string& into);
  /// Forgets what a demonstration has taught: its actions go back to what the
  /// others have taught; what it alone has taught is gone. The names of these
  /// actions, none if it has taught nothing. Refused, and nothing is forgotten,
  /// if it cannot be told from others.
  Result<std::vector<std::string>> TakeBack(const std::string& demonstration);
  /// Nothing is known of the action any more; its name, if it is made up, is
  /// not used again.
  void Forget(const std::string& name);
  /// Showings with other objects join the group if their types are these, one
  /// for each role of the group's model: wider than what was shown.
  /// @throws std::invalid_argument for another number of types.
  void Widen(size_t group, const std::vector<int>& wider);

  /// By name.
  std::vector<Action> Actions() const;
  /// What was learned of the lesson's action up to now.
  Action ActionOf(const Lesson& lesson) const;

 private:
  /// How a showing is like a group.
  struct Match {
    double similarity = 0;
    ActionDirection direction = ActionDirection::kForward;
    RoleMap places;  // of the showing's roles in the group
  };

  void CountMadeUp(const std::string& name);
  ShowingGroup* Find(const std::string& name);
  const TypeHierarchy& types() const { return words_->vocabulary.types(); }
  Match MatchOf(const ShowingGroup& group, const Showing& showing,
                bool needs_types) const;
  double Similarity(const ShowingGroup& group, const Showing& showing,
                    const RoleMap& places) const;
  bool AreTypesKnown(const ShowingGroup& group, const Showing& showing,
                     const RoleMap& places) const;
  LearnedModel ModelOf(const ShowingGroup& group) const;
  SceneFacts Characteristic(const ShowingGroup& group, bool at_pick) const;
  /// What the facts of another group say of one of its own.
  enum class Stance { kSilent, kShares, kContradicts };
  bool IsTelling(const ShowingGroup& group, bool at_pick,
                 const std::function<Stance(const SceneFacts&)>& stance) const;

  std::shared_ptr<const SceneWords> words_;
  std::shared_ptr<const ChainSimilarity> similarity_;
  Params params_;
  std::vector<ShowingGroup> groups_;  // a lesson refers to its place
  size_t num_made_up_ = 0;
};

}  // namespace cell
