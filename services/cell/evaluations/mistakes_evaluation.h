#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/assemblies/assembly_model.h"
#include "services/cell/evaluations/label_counts.h"

namespace cell::cli {

/// Sequences of each toy.
using ToySequences =
    std::map<std::string, std::vector<const assemblies::AssemblySequence*>>;
ToySequences GroupByToy(
    const std::vector<assemblies::AssemblySequence>& sequences);

struct MistakesOptions {
  int num_splits = 4;
  int num_folds = 5;
  uint64_t seed = 1;
  /// Choose the settings for the toys of each fold by those of the others;
  /// else take the defaults.
  bool is_nested = true;
};

/// What judges beside the learned rules.
enum class Control {
  kMajority,     ///< every action is correct
  kEveryDetach,  ///< every detach is a mistake, every attach correct
  kPairOrders    ///< unseen orders of two pairs are mistakes
};
inline constexpr int kNumControls = 3;
const char* NameOf(Control control);

/// An annotated kind of action and its verdicts.
struct KindRow {
  std::map<assemblies::Label, int> verdicts;
  int num_same_kind = 0;  ///< mistakes whose kind was named right
};

struct ToyResult {
  LabelCounts counts;
  std::vector<LabelCounts> controls;  // by Control
  assemblies::JudgeSettings settings;
  int num_sequences = 0;
  int num_actions = 0;
};

struct MistakesResult {
  std::map<std::string, ToyResult> toys;
  std::map<std::string, KindRow> kinds;           ///< by "detach mistake: ..."
  std::vector<assemblies::JudgeSettings> chosen;  ///< of each fold
  int num_unlabelled = 0;
};

/// In each split one random sequence of each toy with two or more is judged,
/// action by action, by what the rest of the split teaches: the toy's other
/// sequences, and those of the other toys that are not judged.
///
/// The settings for the toys of a fold are those with the best macro F1 when
/// each sequence of the toys of the other folds is judged by what these teach:
/// nothing of a judged toy has a part in the choice.
/// @param show  called with the progress
MistakesResult EvaluateMistakes(
    const ToySequences& toys, const MistakesOptions& options,
    const std::function<void(const std::string&)>& show);

}  // namespace cell::cli
