#pragma once

#include <map>
#include <set>

#include "common/assemblies/order_evidence.h"
#include "common/rules/rule.h"

namespace cell::assemblies {

/// What is learned with, and judged by. The defaults did well on real
/// assemblies of 68 toys; `cell eval mistakes` chooses its own.
struct JudgeSettings {
  /// Least probability, that an attach is a wrong order while a pair is
  /// missing, for that pair to become a precondition.
  double least_probability = 0.35;
  /// An attach onto a pair that was just attached in a wrong way is a mistake
  /// too, since it has to be undone first.
  bool builds_on_mistakes = true;
  /// A first attach is said to be in a wrong position if at least this share of
  /// the pair's attaches was; above 1: never.
  double least_wrong_position = 0.25;
  bool operator==(const JudgeSettings&) const = default;
};

/// Learned rules of one toy's actions, and the goal that its assemblies reach.
struct AssemblyModel {
  /// An action attach_A__B for each pair, without arguments; parts are
  /// constants, and joined(A, B) says what is attached. The preconditions are
  /// the pairs that have to be attached before. Outcomes: the pair is joined;
  /// it is misplaced; noise.
  rules::NdrRules rules;
  std::set<PartPair> goal;          ///< pairs that were attached correctly
  std::set<std::string> parts;      ///< of the goal
  std::map<PartPair, int> rule_of;  ///< index in rules.rules
  int num_sequences = 0;            ///< learned from
};

/// Learns what each attach requires. A pair q becomes a precondition of p if it
/// was attached before every durable attach of p (an attach that is correct and
/// never undone), and if p without q is a wrong order with at least the
/// settings' probability; the likeliest first, and none that would make the
/// goal unreachable (a pair that the goal does not have, or a cycle): people
/// have reached it. The probability is estimated as the mean of a beta
/// distribution: the counts of this toy over a prior of one observation, whose
/// mean is estimated in the same way from the other toys.
///
/// Greedy search for rules that maximise eq. (1) needs dozens of experiences of
/// an action; of a toy there are one to six sequences, in which every order
/// that was seen is explained by many contexts. Hence this estimate, which
/// shares the evidence among toys; its result is rules like any other.
AssemblyModel LearnModel(const OrderEvidence& toy, const OrderPrior& others,
                         const JudgeSettings& settings);

/// The pair of a literal joined(A, B) of the model's rules.
PartPair PairOf(const rules::Literal& literal, const rules::NdrRules& rules);

}  // namespace cell::assemblies
