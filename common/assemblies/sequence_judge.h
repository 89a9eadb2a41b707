#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/assemblies/assembly_model.h"
#include "common/rules/world.h"

namespace cell::assemblies {

struct Verdict {
  Label label = Label::kCorrect;
  MistakeKind kind = MistakeKind::kNone;  ///< of a mistake
  int plan_before = 0;  ///< actions of the shortest plan to the goal
  int plan_after = 0;
  std::string reason;  ///< in plain words
};

/// Judges one person's actions as they come, by the past and its own verdicts.
/// An attach in a wrong way leaves a pair that stands but has to be undone. An
/// action that makes the shortest plan to the goal longer is a mistake; a
/// detach that makes it shorter is a correction. A detach of anything else is a
/// mistake too, even if it is of a pair that the goal does not have.
///
/// The plan: all preconditions are positive, and nothing that is attached in
/// the right way is ever in the way. So a plan needs a detach for each pair
/// that was attached in a wrong way, and an attach for each pair of the goal
/// that does not stand in the right way, and no more: first the detaches, then
/// the attaches, in an order of the preconditions. Their number is exact, and
/// needs no search.
class SequenceJudge {
 public:
  /// The model must outlive it.
  SequenceJudge(const AssemblyModel& model, const JudgeSettings& settings);

  Verdict Judge(Verb verb, const PartPair& pair);
  /// Actions of the shortest plan to the goal.
  int PlanLength() const;

 private:
  struct Standing {
    bool is_sound = true;
    /// A pair of the goal whose place it takes: people do not always name the
    /// same two of several parts that meet.
    std::optional<PartPair> stands_for;
  };
  struct Fault {
    MistakeKind kind;
    std::string reason;
  };

  std::optional<Fault> FaultOf(const PartPair& pair,
                               const std::optional<PartPair>& stands_for) const;
  std::vector<PartPair> MissingFor(const PartPair& pair) const;
  double WrongPositionShare(const PartPair& pair) const;
  std::optional<PartPair> OpenGoalBetween(const PartPair& pair) const;
  bool AreConnected(const std::string& a, const std::string& b) const;
  bool IsUnknown(const PartPair& pair) const;
  void Attach(const PartPair& pair, const Standing& standing);
  void SetJoined(const PartPair& pair, bool is_joined);
  Verdict JudgeAttach(const PartPair& pair);
  Verdict JudgeDetach(const PartPair& pair);

  const AssemblyModel& model_;
  JudgeSettings settings_;
  rules::World world_;
  rules::WorldState state_;
  int joined_ = 0;
  std::map<PartPair, Standing> standing_;
  std::vector<PartPair> order_;  // of standing_, by when they were attached
  std::map<PartPair, int> num_attaches_;
};

}  // namespace cell::assemblies
