#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/actions/action_models.h"
#include "common/actions/action_record.h"
#include "common/actions/generic_skill.h"
#include "common/result/result.h"
#include "common/sec/sec_learner.h"

namespace cell::recognizer {

/// Learns actions while it watches: what was shown becomes, or changes, a
/// record of the library.
class Learning {
 public:
  /// @param skill  by which arms do what was only shown
  Learning(const ActionModels& actions, GenericSkill skill);

  /// What a manipulation has shown: an action of the library, or one that is
  /// new there, with its objects in its order.
  struct Shown {
    std::string action;
    std::vector<std::string> arguments;
  };
  /// nullopt if it has shown nothing, or an action taken back.
  /// @param source  names the demonstration
  std::optional<Shown> OnManipulation(const ObservedManipulation& manipulation,
                                      const std::string& source,
                                      const ActionModels& actions);
  /// A manipulation that shows nothing by itself: it cannot be named.
  void OnMixture() { last_.reset(); }
  /// A person's name of the manipulation that was observed last; `is_undone`:
  /// it undoes the action. What is known now, in plain words.
  Result<std::string> Name(const std::string& name, bool is_undone,
                           const ActionModels& actions);
  /// A record from the library: later showings of the action refine it.
  void OnRecord(const std::string& name, const ActionModels& actions);

  /// What has only confirmed an action is kept now, too.
  void OnDemonstrationEnd();

  /// Records that say something else than `actions`, each once: until the
  /// library has answered, that action is left out.
  std::vector<ActionRecord> TakeChanges(const ActionModels& actions);
  /// The library refused what was asked for.
  void OnRefusal() { requested_.clear(); }

 private:
  void ReadAsWhatArmsCanDo();
  void WidenTo(const std::vector<Variable>& arguments, size_t group,
               const TypeHierarchy& types);
  std::optional<ActionRecord> ChangeOf(const SecLearner::Action& action,
                                       const ActionModels& actions,
                                       bool keeps_confirmations) const;

  std::optional<Shown> ShownBy(const SecLearner::Lesson& lesson,
                               const ActionModels& actions) const;
  Action ActionOf(const SecLearner::Action& learned) const;

  SecLearner learner_;
  GenericSkill skill_;
  std::optional<SecLearner::Lesson> last_;
  bool has_news_ = false;
  bool keeps_confirmations_ = false;
  std::set<std::string> requested_;  // names
  std::set<std::string> renamed_;    // made-up names that are not used any more
};

}  // namespace cell::recognizer
